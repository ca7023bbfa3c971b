"""How the robot moves, and the commands that it chooses from: one object for each kind of base."""

from socialnav_core.simulation.kinematics.differential import DifferentialDrive
from socialnav_core.simulation.kinematics.holonomic import Holonomic
from socialnav_core.simulation.kinematics.limits import Limits, limits_of
from socialnav_core.simulation.kinematics.protocol import Kinematics

__all__ = [
    'BY_NAME', 'DifferentialDrive', 'Holonomic', 'Kinematics', 'Limits', 'kinematics_of',
    'limits_of',
]  # fmt: skip

BY_NAME: dict[str, Kinematics] = {'holonomic': Holonomic(), 'differential': DifferentialDrive()}
"""The objects behind the names that settings, checkpoints and ROS parameters use."""


def kinematics_of(name: str) -> Kinematics:
    """Return the kinematics that a setting names; configurations have checked the name."""
    return BY_NAME[name]
