"""
People of whom some look at their phones and give way to nobody; the others avoid them by ORCA.

Three in ten pedestrians do something that distracts them (Thompson, Rivara, Ayyagari and Ebel,
Impact of social and technological distraction on pedestrian crossing behaviour, Injury Prevention
19, 2013).
"""

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import renew_goals, velocities_to_goals
from socialnav_core.simulation.crowds.orca_people import walk_by_orca
from socialnav_core.simulation.random_streams import uniform

SHARE = 0.3
"""Probability that somebody looks at a phone."""


def make_crowd(scenario: Scenario, batch_size: int) -> 'DistractedCrowd':
    """Return the crowd."""
    return DistractedCrowd(batch_size, scenario.pedestrians)


class DistractedCrowd:
    """Remembers who looks at a phone."""

    def __init__(self, batch_size: int, people: int) -> None:
        """Make room; `reset` fills it."""
        self._blind = np.zeros((batch_size, people), bool)

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Draw who looks at a phone in some worlds."""
        for world in worlds:
            for person in range(self._blind.shape[1]):
                stream = episodes.goal_streams[world, person]
                self._blind[world, person] = uniform(stream, 0.0, 1.0) < SHARE

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write the velocities; see Crowd.decide."""
        agents = episodes.state.agents.count
        walk_by_orca(episodes, due, velocities_to_goals(episodes, agents), self._blind, velocities)

    def renew_goals(self, episodes: Episodes) -> None:
        """Give another goal to whoever has arrived; see Crowd.renew_goals."""
        renew_goals(episodes)

    def get_state(self) -> dict[str, np.ndarray]:
        """Return who looks at a phone."""
        return {'blind': self._blind.copy()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from there."""
        self._blind = arrays['blind'].copy()
