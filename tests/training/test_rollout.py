"""Laws of collection."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.policies import observe, ValuePolicy
from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.lookahead import Decision
from socialnav_core.simulation import make_scenario
from socialnav_core.training.randomness import initial_network
from socialnav_core.training.rollout import explore, value_at_cut
from socialnav_core.training.run import Run
from socialnav_core.training.value_learning import learn

WORLDS, STEPS = 6, 12


def make_run(config, time_limit=25.0, trace_decay=0.7):
    """Return a run with random weights and its first decision."""
    settings = dataclasses.replace(
        config.training, worlds=WORLDS, steps_per_iteration=STEPS, trace_decay=trace_decay,
        lookahead='oracle', bfloat16=False,
    )  # fmt: skip
    scenario = dataclasses.replace(make_scenario('simple'), time_limit=time_limit)
    run = Run(dataclasses.replace(config, training=settings, scenario=scenario))
    run.decision = run.policy.decide(run.simulator.reset(seed=0, split='train'))
    return run


def rollout_of(run, epsilon=0.0):
    """Return what an iteration brings whose updates change no weight."""
    return learn(run, rate=0.0, exploration=epsilon)[0]


def test_rollout_holds_every_step_of_every_world(tiny_config):
    rollout = rollout_of(make_run(tiny_config))
    assert rollout.observation.robot.shape == (STEPS * WORLDS, 6)
    assert rollout.target.shape == (STEPS * WORLDS,) and np.isfinite(rollout.target).all()


def test_first_states_of_a_rollout_are_those_decided_upon(tiny_config):
    run = make_run(tiny_config)
    seen = observe(run.simulator.state)
    np.testing.assert_array_equal(rollout_of(run).observation.others[:WORLDS], seen.others)


def test_one_step_targets_follow_from_rewards_and_the_next_decisions(tiny_config):
    run = make_run(tiny_config)
    state, reward, terminated, _, _ = run.simulator.step(run.decision.command())
    later = np.where(terminated, 0, run.policy.decide(state).maximum())
    rollout = rollout_of(make_run(tiny_config, trace_decay=0.0))
    expected = reward + run.simulator.scenario.discount * later
    assert rollout.target[:WORLDS] == pytest.approx(expected, abs=1e-6)


def test_frozen_network_values_the_states_that_exploration_really_led_to(tiny_config):
    frozen = ValueInference(initial_network(tiny_config.policy, seed=7))
    run = make_run(tiny_config, time_limit=2.0)
    run.frozen = frozen
    rollout = rollout_of(run, epsilon=0.8)
    seen, first = rollout.observation, slice(0, WORLDS)
    value = frozen.values(seen.robot, seen.others, seen.mask).reshape(STEPS, WORLDS)
    discount = make_scenario('simple').discount
    going = rollout.episode[first] == rollout.episode[WORLDS : 2 * WORLDS]
    reward = rollout.target[first] - discount * value[1]
    assert going.any()
    free = going & (np.abs(reward) < 1e-6)  # neither the goal nor discomfort
    assert free.any()
    assert (np.abs(reward[going]) < 0.05).all()


def test_states_know_their_episode(tiny_config):
    rollout = rollout_of(make_run(tiny_config, time_limit=1.0))
    lengths = np.bincount(rollout.episode)
    assert rollout.episode[:WORLDS].tolist() == list(range(WORLDS))
    assert (lengths[rollout.case_index] == rollout.time / 0.25).all()


def test_last_decision_is_that_of_the_present_state(tiny_config):
    run = make_run(tiny_config)
    rollout_of(run, epsilon=0.3)
    expected = run.policy.decide(run.simulator.state)
    np.testing.assert_array_equal(run.decision.values, expected.values)


def test_every_episode_that_ended_is_reported_once(tiny_config):
    run = make_run(tiny_config, time_limit=1.0)
    rollout = rollout_of(run)
    begun = run.simulator.case_index.max() + 1
    running = set(run.simulator.case_index.tolist())
    assert sorted(rollout.case_index.tolist()) == sorted(set(range(begun)) - running)
    assert (rollout.time <= 1.0).all()


def test_truncated_episode_is_worth_what_its_last_state_promised(tiny_config):
    run = make_run(tiny_config, time_limit=0.25)
    _, reward, _, truncated, info = run.simulator.step(run.decision.command())
    assert truncated.any()
    config = dataclasses.replace(run.policy.config, lookahead='constant_velocity')
    promised = ValuePolicy(run.network, config).decide(info['final_state']).maximum()
    rollout = rollout_of(make_run(tiny_config, time_limit=0.25))
    expected = reward + run.simulator.scenario.discount * promised
    assert rollout.target[:WORLDS][truncated] == pytest.approx(expected[truncated], abs=1e-6)


def test_only_episodes_that_were_cut_bootstrap_from_their_last_state(tiny_config):
    run = make_run(tiny_config)
    truncated = np.array([True] + [False] * (WORLDS - 1))
    values = value_at_cut(run.policy, run.simulator.state, truncated)
    assert values[0] != 0 and not values[1:].any()


def decision_of(batch, actions):
    """Return a decision in which the last action is the best everywhere."""
    values = np.tile(np.arange(actions, dtype=np.float32), (batch, 1))
    return Decision(np.zeros((batch, actions, 2)), values, values.argmax(axis=1))


def test_actions_are_the_best_ones_without_exploration():
    action = explore(decision_of(50, 5), 0.0, np.random.default_rng(0))
    assert (action == 4).all()


def test_exploration_draws_from_all_actions_alike():
    action = explore(decision_of(5000, 5), 1.0, np.random.default_rng(0))
    np.testing.assert_allclose(np.bincount(action) / 5000, 0.2, atol=0.03)


def test_share_of_random_actions_is_epsilon():
    action = explore(decision_of(20000, 5), 0.25, np.random.default_rng(0))
    assert (action != 4).mean() == pytest.approx(0.25 * 4 / 5, abs=0.02)
