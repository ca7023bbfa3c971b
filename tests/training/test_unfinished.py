"""Laws of holding states back until their episode ends."""

import numpy as np

from socialnav_core.simulation import Outcome
from socialnav_core.states import Observation
from socialnav_core.training.rollout import Rollout
from socialnav_core.training.unfinished import UnfinishedEpisodes

AGENTS = 2


def rollout(episode, ended=(), outcome=Outcome.GOAL):
    """Return a rollout whose targets are 10 times the episode of their state."""
    count = len(episode)
    seen = Observation(
        np.tile(np.array(episode, np.float32)[:, None], (1, 6)),
        np.zeros((count, AGENTS, 7), np.float32),
        np.ones((count, AGENTS), bool),
    )
    episode, ended = np.array(episode, np.int64), np.array(ended, np.int64)
    outcomes, times = np.full(len(ended), outcome), np.full(len(ended), 5.0)
    return Rollout(seen, 10.0 * episode, episode, ended, outcomes, times)


def released(unfinished, rollout):
    """Return the episodes of the states released."""
    seen, target = unfinished.release(rollout)
    np.testing.assert_array_equal(seen.robot[:, 0] * 10, target)
    assert len(seen.others) == len(seen.mask) == len(target)
    return seen.robot[:, 0].tolist()


def test_states_wait_for_the_end_of_their_episode_and_come_in_their_order():
    unfinished = UnfinishedEpisodes(AGENTS)
    assert released(unfinished, rollout([0, 1, 0, 1])) == []
    assert released(unfinished, rollout([0, 1, 2, 1], ended=[0])) == [0, 0, 0]
    assert released(unfinished, rollout([2, 1], ended=[1, 2])) == [1, 1, 1, 2, 1, 2, 1]


def test_states_of_a_timeout_never_come():
    unfinished = UnfinishedEpisodes(AGENTS)
    assert released(unfinished, rollout([0, 1])) == []
    assert released(unfinished, rollout([0, 1], ended=[0], outcome=Outcome.TIMEOUT)) == []
    assert released(unfinished, rollout([1], ended=[1])) == [1, 1, 1]


def test_stored_states_wait_like_the_originals():
    original, copy = UnfinishedEpisodes(AGENTS), UnfinishedEpisodes(AGENTS)
    original.release(rollout([0, 1, 0]))
    copy.set_state(original.get_state())
    for unfinished in (original, copy):
        assert released(unfinished, rollout([0], ended=[0, 1])) == [0, 1, 0, 0]
