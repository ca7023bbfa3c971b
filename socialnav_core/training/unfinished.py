"""States of episodes that still run, where the end decides whether they are replayed."""

import numpy as np

from socialnav_core.simulation import Outcome
from socialnav_core.states import Observation
from socialnav_core.training.rollout import Rollout


class UnfinishedEpisodes:
    """Holds states back until their episode ends; those of a time-out are dropped."""

    def __init__(self, agents: int) -> None:
        """
        Hold nothing.

        :param agents: agent slots of a state, padding included.
        """
        self._seen = Observation.empty(agents)
        self._target = np.zeros(0)
        self._episode = np.zeros(0, np.int64)

    def release(self, rollout: Rollout) -> tuple[Observation, np.ndarray]:
        """Take in a rollout and return the states, and their targets, of what ended otherwise."""
        seen = Observation.concatenate([self._seen, rollout.observation])
        target = np.concatenate([self._target, rollout.target])
        episode = np.concatenate([self._episode, rollout.episode])
        ended = np.isin(episode, rollout.case_index)
        late = np.isin(episode, rollout.case_index[rollout.outcome == Outcome.TIMEOUT])
        self._seen = seen.select(~ended)
        self._target, self._episode = target[~ended], episode[~ended]
        return seen.select(ended & ~late), target[ended & ~late]

    def get_state(self) -> dict[str, np.ndarray]:
        """Return what set_state needs to continue from here."""
        seen = self._seen
        return {
            'robot': seen.robot, 'others': seen.others, 'mask': seen.mask,
            'target': self._target, 'episode': self._episode,
        }  # fmt: skip

    def set_state(self, state: dict[str, np.ndarray]) -> None:
        """Continue from a stored state."""
        self._seen = Observation(state['robot'], state['others'], state['mask'])
        self._target, self._episode = state['target'], state['episode']
