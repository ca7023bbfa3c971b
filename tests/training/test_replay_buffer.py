"""Laws of the replay buffer."""

import numpy as np

from socialnav_core.states import Observation
from socialnav_core.training.replay_buffer import ReplayBuffer

AGENTS = 2


def states(values):
    """Return states that are recognised by their target, which is in every feature as well."""
    values = np.array(values, np.float32)
    robot = np.repeat(values[:, None], 6, axis=1)
    others = np.broadcast_to(values[:, None, None], (len(values), AGENTS, 7))
    mask = np.ones((len(values), AGENTS), bool)
    return Observation(robot, others, mask), values


def contents(buffer):
    """Return the targets in the buffer in ascending order."""
    return sorted(buffer.get_state()['target'].tolist())


def test_buffer_keeps_all_states_until_it_is_full():
    buffer = ReplayBuffer(5, AGENTS)
    buffer.append(*states([1, 2, 3]))
    assert contents(buffer) == [1, 2, 3]


def test_full_buffer_forgets_the_oldest_states():
    buffer = ReplayBuffer(5, AGENTS)
    for first in (1, 4, 7):
        buffer.append(*states(range(first, first + 3)))
    assert contents(buffer) == [5, 6, 7, 8, 9]


def test_more_states_than_fit_leave_the_last_ones():
    buffer = ReplayBuffer(3, AGENTS)
    buffer.append(*states(range(8)))
    assert contents(buffer) == [5, 6, 7]


def test_features_stay_with_their_target():
    buffer = ReplayBuffer(4, AGENTS)
    for first in range(0, 9, 3):
        buffer.append(*states(range(first, first + 3)))
    robot, others, _, target = buffer.sample(np.random.default_rng(0), 50)
    assert (robot == target[:, None]).all() and (others == target[:, None, None]).all()


def test_every_state_is_drawn_at_last():
    buffer = ReplayBuffer(10, AGENTS)
    buffer.append(*states(range(4)))
    target = buffer.sample(np.random.default_rng(0), 200)[-1]
    assert set(target.tolist()) == {0, 1, 2, 3}


def test_the_same_generator_draws_the_same_states():
    buffer = ReplayBuffer(10, AGENTS)
    buffer.append(*states(range(10)))
    first, second = (buffer.sample(np.random.default_rng(3), 20)[-1] for _ in range(2))
    assert (first == second).all()


def test_stored_buffer_goes_on_like_the_original():
    original, copy = ReplayBuffer(5, AGENTS), ReplayBuffer(5, AGENTS)
    original.append(*states(range(7)))
    copy.set_state({name: array.copy() for name, array in original.get_state().items()})
    for buffer in (original, copy):
        buffer.append(*states([20, 21]))
    for name, array in original.get_state().items():
        np.testing.assert_array_equal(array, copy.get_state()[name])
