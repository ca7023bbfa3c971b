"""A robot that drives in any direction at once."""

import math

import numpy as np

from socialnav_core.config import PolicyConfig
from socialnav_core.simulation.kinematics.angles import direction, rotated
from socialnav_core.simulation.kinematics.limits import Limits, longer, shortened
from socialnav_core.simulation.kinematics.speeds import exponential_speeds
from socialnav_core.states import Robot


class Holonomic:
    """Follows any velocity in the plane and keeps its heading; `Kinematics` says what is what."""

    has_heading = False
    straight = True
    directions = 'headings'

    def action_set(self, config: PolicyConfig) -> np.ndarray:
        """Return the stop, and every speed along headings all around the world frame."""
        angles = np.linspace(0.0, 2.0 * math.pi, config.headings, endpoint=False)
        moves = exponential_speeds(config.speeds)[:, None, None] * direction(angles)
        return np.concatenate([np.zeros((1, 2)), moves.reshape(-1, 2)])

    def scale(self, actions: np.ndarray, preferred_speed: np.ndarray) -> np.ndarray:
        """Return the commands at each robot's speed."""
        return actions * preferred_speed[:, None, None]

    def move(
        self, heading: np.ndarray, command: np.ndarray, duration: float
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return displacement, velocity and heading after a straight line."""
        return command * duration, command, heading

    def present_command(self, robot: Robot) -> np.ndarray:
        """Return the velocity."""
        return robot.velocity

    def turn_rates(self, command: np.ndarray) -> np.ndarray:
        """Return zeros: such a base never turns."""
        return np.zeros(command.shape[:-1])

    def reachable(
        self, commands: np.ndarray, present: np.ndarray, limits: Limits, duration: float
    ) -> np.ndarray:
        """Return the commands with the change of velocity, and then the velocity, cut short."""
        change = limits.acceleration * duration
        present = shortened(present, limits.speed)
        wanted = commands - present
        changed = np.where(longer(wanted, change), present + shortened(wanted, change), commands)
        return shortened(changed, limits.speed)

    def mean_command(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        """Return the mean velocity."""
        return 0.5 * (first + last)

    def to_base(self, command: np.ndarray, heading: float) -> np.ndarray:
        """Return a velocity of the world in the robot's own frame."""
        return rotated(command, -heading)

    def from_base(self, command: np.ndarray, heading: float) -> np.ndarray:
        """Return a velocity of the robot's own frame in the world."""
        return rotated(command, heading)

    def twist(self, command: np.ndarray) -> tuple[float, float, float]:
        """Return the speeds of a base that never turns."""
        forward, left = command.tolist()
        return forward, left, 0.0

    def from_twist(self, forward: float, left: float, turn_rate: float) -> np.ndarray:
        """Return the velocity alone."""
        return np.array([forward, left])
