"""The simulated world: scenarios, pedestrians, the robot's motion and rewards."""

from socialnav_core.config.scenarios import make_scenario, resolve_scenario, SCENARIOS
from socialnav_core.simulation.crowds.orca_velocities import orca_velocities
from socialnav_core.simulation.layout import PackingError
from socialnav_core.simulation.rewards import Outcome
from socialnav_core.simulation.simulator import Simulator

__all__ = [
    'SCENARIOS',
    'Outcome',
    'PackingError',
    'Simulator',
    'make_scenario',
    'orca_velocities',
    'resolve_scenario',
]
