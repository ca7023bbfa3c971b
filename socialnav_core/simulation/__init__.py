"""The simulated world: scenarios, pedestrians, the robot's motion, rewards and observations."""

from socialnav_core.simulation.observation import observe
from socialnav_core.simulation.orca import orca_velocities
from socialnav_core.simulation.rewards import Outcome
from socialnav_core.simulation.sampling import PackingError
from socialnav_core.simulation.scenarios import make_scenario, resolve_scenario, SCENARIOS
from socialnav_core.simulation.simulator import Simulator

__all__ = [
    'SCENARIOS',
    'Outcome',
    'PackingError',
    'Simulator',
    'make_scenario',
    'observe',
    'orca_velocities',
    'resolve_scenario',
]
