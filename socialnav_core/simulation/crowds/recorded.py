"""Recorded people who do again what they did: they come, go, and react to nobody."""

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.recorded import first_moment, Replay, replay_of

LEAST_GAP = 1.0
"""
Nobody appears nearer to the robot, m from rim to rim: who comes into the picture would come onto
it. From so far a robot of 1 m/s can step aside of somebody of 1.5 m/s.
"""


def make_crowd(scenario: Scenario, batch_size: int) -> 'RecordedCrowd':
    """Return the crowd."""
    return RecordedCrowd(replay_of(scenario), batch_size)


class RecordedCrowd:
    """Knows the moment of the recording at which each world began."""

    def __init__(self, replay: Replay, batch_size: int) -> None:
        """Make room; `reset` fills it."""
        self._replay = replay
        self._begin = np.zeros(batch_size, np.int64)

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Put people where they were when the cases of some worlds begin."""
        queue = episodes.queue
        for world in worlds:
            case = int(episodes.case_index[world])
            self._begin[world] = first_moment(episodes.scenario, queue.split, queue.seed, case)
        episodes.state.agents.valid[worlds] = False
        episodes.state.agents.position[worlds] = 0.0
        self.come_and_go(episodes, worlds, least_gap=0.0)

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write what people did then; see Crowd.decide."""
        replay, slots = self._replay, self._replay.there.shape[1]
        moments = self.moments(episodes)
        moving = np.where(replay.there[moments][..., None], replay.velocity[moments], 0.0)
        velocities[due, :slots] = moving[due]

    def renew_goals(self, episodes: Episodes) -> None:
        """Let people come and go; called after each step."""
        self.come_and_go(episodes, np.flatnonzero(episodes.active))

    def come_and_go(
        self, episodes: Episodes, worlds: np.ndarray, least_gap: float = LEAST_GAP
    ) -> None:
        """
        Put those who come where they were, with the velocity that they had.

        :param least_gap: who would appear nearer to the robot is not there until farther away, m.
        """
        replay, agents, robot = self._replay, episodes.state.agents, episodes.state.robot
        slots = replay.there.shape[1]
        moments = self.moments(episodes)[worlds]
        there, known = replay.there[moments], agents.valid[worlds, :slots]
        gap = np.linalg.norm(replay.position[moments] - robot.position[worlds, None], axis=-1)
        gap -= agents.radius[worlds, :slots] + robot.radius[worlds, None]
        there &= known | (gap >= least_gap)
        row, slot = np.nonzero(there & ~known)
        agents.position[worlds[row], slot] = replay.position[moments[row], slot]
        agents.velocity[worlds[row], slot] = replay.velocity[moments[row] - 1, slot]
        row, slot = np.nonzero(known & ~there)
        agents.velocity[worlds[row], slot] = 0.0
        agents.valid[worlds, :slots] = there

    def moments(self, episodes: Episodes) -> np.ndarray:
        """Return the moment of the recording that each world is at, int64 (batch,)."""
        steps = episodes.state.time / episodes.scenario.time_step
        moments = self._begin + np.floor(steps + 1e-6).astype(np.int64)
        return np.minimum(moments, len(self._replay.there) - 1)

    def get_state(self) -> dict[str, np.ndarray]:
        """Return when the worlds began."""
        return {'begin': self._begin.copy()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from there."""
        self._begin = arrays['begin'].copy()
