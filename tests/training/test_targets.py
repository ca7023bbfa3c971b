"""Laws of the targets."""

import numpy as np
import pytest

from socialnav_core.training.targets import discounted_returns, one_step_targets, q_lambda_targets

DISCOUNT = 0.9
STEPS, WORLDS = 6, 4


def window(seed=0):
    """Return a random window with every kind of step in it."""
    draws = np.random.default_rng(seed)
    kind = draws.integers(4, size=(STEPS, WORLDS))
    return {
        'reward': draws.normal(size=(STEPS, WORLDS)),
        'terminated': kind == 0,
        'truncated': kind == 1,
        'greedy': draws.random((STEPS, WORLDS)) < 0.7,
        'best_value': draws.normal(size=(STEPS + 1, WORLDS)),
        'final_value': draws.normal(size=(STEPS, WORLDS)),
    }


def recursive_target(data, step, world, trace_decay):
    """Return G_t by its definition, one number at a time."""
    if step == len(data['reward']) or not data['greedy'][step, world]:
        return data['best_value'][step, world]
    reward = data['reward'][step, world]
    if data['terminated'][step, world]:
        return reward
    if data['truncated'][step, world]:
        return reward + DISCOUNT * data['final_value'][step, world]
    later = recursive_target(data, step + 1, world, trace_decay)
    best = data['best_value'][step + 1, world]
    return reward + DISCOUNT * ((1 - trace_decay) * best + trace_decay * later)


def targets(data, trace_decay):
    """Return the targets of a window."""
    return q_lambda_targets(**data, discount=DISCOUNT, trace_decay=trace_decay)


@pytest.mark.parametrize('trace_decay', [0.0, 0.7, 1.0])
@pytest.mark.parametrize('seed', range(5))
def test_targets_equal_the_recursive_definition(seed, trace_decay):
    data = window(seed)
    expected = [
        [recursive_target(data, step, world, trace_decay) for world in range(WORLDS)]
        for step in range(STEPS)
    ]
    np.testing.assert_allclose(targets(data, trace_decay), expected)


def test_terminal_step_is_worth_its_reward_alone():
    data = window() | {'terminated': np.ones((STEPS, WORLDS), bool)}
    data['greedy'] = np.ones((STEPS, WORLDS), bool)
    np.testing.assert_array_equal(targets(data, 0.7), data['reward'])


def test_values_after_the_end_of_an_episode_do_not_reach_back():
    data = window()
    data['greedy'][:] = True
    data['terminated'][2], data['truncated'][2] = True, False
    before = targets(data, 1.0)[:3].copy()
    data['best_value'][3:] += 100
    np.testing.assert_array_equal(targets(data, 1.0)[:3], before)


def test_truncated_step_bootstraps_from_where_it_was_cut():
    data = window()
    data['greedy'][:] = True
    data['terminated'][:], data['truncated'][:] = False, True
    expected = data['reward'] + DISCOUNT * data['final_value']
    np.testing.assert_allclose(targets(data, 0.7), expected)


def test_exploratory_step_is_worth_the_best_value_whatever_came_of_it():
    data = window()
    data['greedy'][3] = False
    data['reward'][3] += 100
    np.testing.assert_array_equal(targets(data, 0.7)[3], data['best_value'][3])


def test_lambda_zero_looks_one_step_ahead():
    data = window()
    data['greedy'][:] = True
    data['terminated'][:], data['truncated'][:] = False, False
    expected = data['reward'] + DISCOUNT * data['best_value'][1:]
    np.testing.assert_allclose(targets(data, 0.0), expected)


def test_lambda_one_sums_rewards_to_the_end_of_the_window():
    data = window()
    data['greedy'][:] = True
    data['terminated'][:], data['truncated'][:] = False, False
    powers = DISCOUNT ** np.arange(STEPS)[:, None]
    expected = (powers * data['reward']).sum(axis=0) + DISCOUNT**STEPS * data['best_value'][-1]
    np.testing.assert_allclose(targets(data, 1.0)[0], expected)


def test_returns_are_discounted_sums_that_stop_at_the_end_of_an_episode():
    reward = np.array([[1.0], [2.0], [4.0], [8.0]])
    ended = np.array([[False], [True], [False], [True]])
    expected = [[1 + 2 * 0.5], [2.0], [4 + 8 * 0.5], [8.0]]
    np.testing.assert_allclose(discounted_returns(reward, ended, 0.5), expected)


def test_one_step_targets_look_at_the_next_state_unless_there_is_none():
    reward, value = np.array([[1.0, 2.0]]), np.array([[10.0, 20.0]])
    terminated = np.array([[False, True]])
    np.testing.assert_allclose(one_step_targets(reward, terminated, value, 0.5), [[6.0, 2.0]])
