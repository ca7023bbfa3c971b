"""People who stop all of a sudden and go on after a while; else they walk by ORCA."""

import math

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import renew_goals, velocities_to_goals
from socialnav_core.simulation.crowds.orca_people import walk_by_orca
from socialnav_core.simulation.motion import TIME_TOLERANCE
from socialnav_core.simulation.random_streams import uniform

STOP_RATE = 0.12
"""Somebody who walks stops so often, 1/s."""
PAUSES = (0.5, 4.0)
"""Shortest and longest pause, s."""


def make_crowd(scenario: Scenario, batch_size: int) -> 'StopAndGoCrowd':
    """Return the crowd."""
    return StopAndGoCrowd(batch_size, scenario.pedestrians)


class StopAndGoCrowd:
    """Remembers who stands, and when each person will stop or go on."""

    def __init__(self, batch_size: int, people: int) -> None:
        """Make room; `reset` fills it."""
        self._standing = np.zeros((batch_size, people), bool)
        self._change = np.zeros((batch_size, people))

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Let everybody of some worlds walk, and draw when they stop first."""
        self._standing[worlds] = True
        self._change[worlds] = 0.0
        self._change_minds(episodes, worlds)

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write the velocities; see Crowd.decide. Who stands steps aside for nobody."""
        self._change_minds(episodes, np.flatnonzero(due))
        preferred = velocities_to_goals(episodes, episodes.state.agents.count)
        preferred[:, : self._standing.shape[1]][self._standing] = 0.0
        walk_by_orca(episodes, due, preferred, self._standing, velocities)

    def renew_goals(self, episodes: Episodes) -> None:
        """Give another goal to whoever has arrived; see Crowd.renew_goals."""
        renew_goals(episodes)

    def get_state(self) -> dict[str, np.ndarray]:
        """Return who stands, and when that changes."""
        return {'standing': self._standing.copy(), 'change': self._change.copy()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from there."""
        self._standing, self._change = arrays['standing'].copy(), arrays['change'].copy()

    def _change_minds(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Let those stop or go on in some worlds for whom it is time."""
        now = episodes.state.time[:, None] + TIME_TOLERANCE
        chosen = np.zeros_like(self._standing)
        chosen[worlds] = True
        for world, person in np.argwhere(chosen & (self._change <= now)):
            stream = episodes.goal_streams[world, person]
            stands = self._standing[world, person] = not self._standing[world, person]
            if stands:
                wait = uniform(stream, *PAUSES)
            else:
                wait = -math.log(1.0 - uniform(stream, 0.0, 1.0)) / STOP_RATE
            self._change[world, person] = episodes.state.time[world] + wait
