"""People who walk straight to their goals and react to nobody: the hardest to live with."""

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import velocities_to_goals
from socialnav_core.simulation.crowds.memoryless import Memoryless


def make_crowd(scenario: Scenario, batch_size: int) -> Memoryless:
    """Return the crowd: a decision depends on the present state alone."""
    return Memoryless(decide)


def decide(episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
    """Write what people want, whoever is in the way; see Crowd.decide."""
    movers = episodes.scenario.pedestrians
    velocities[due, :movers] = velocities_to_goals(episodes, movers)[due]
