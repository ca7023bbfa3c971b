"""Laws of choosing within what the robot can do."""

import dataclasses
import math

import numpy as np
import pytest
import torch

from socialnav_core.config import PolicyConfig, ScreeningConfig
from socialnav_core.evaluation import evaluate
from socialnav_core.policies import build_network, StraightLinePolicy, ValuePolicy
from socialnav_core.policies.value.screening import safe_actions
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.simulation.kinematics import Holonomic, kinematics_of, Limits, limits_of

NONE = Limits(1.0, math.inf, math.inf, 0.1)
TIGHT = Limits(0.8, 1.0, 1.0, 0.1)
KINEMATICS = ['holonomic', 'differential']


def policy_of(kinematics='holonomic', screened=True):
    torch.manual_seed(1)
    config = PolicyConfig(kinematics=kinematics, screening=ScreeningConfig(enabled=screened))
    return ValuePolicy(build_network(config), config)


def states_of(kinematics='holonomic', worlds=4, steps=4):
    """Return some worlds, under way, with robots at different speeds."""
    scenario = dataclasses.replace(make_scenario('hard'), kinematics=kinematics)
    simulator = Simulator(scenario, worlds)
    state = simulator.reset(seed=1, split='train')
    policy = policy_of(kinematics, screened=False)
    for _ in range(steps):
        yield state
        state = simulator.step(policy.act(state))[0]


@pytest.mark.parametrize('kinematics', KINEMATICS)
def test_without_limits_that_count_every_decision_is_the_same(kinematics):
    policy = policy_of(kinematics)
    for state in states_of(kinematics):
        one, other = policy.decide(state), policy.decide(state, NONE)
        np.testing.assert_array_equal(one.commands, other.commands)
        np.testing.assert_array_equal(one.values, other.values)


@pytest.mark.parametrize('kinematics', KINEMATICS)
def test_every_candidate_is_within_the_limits(kinematics):
    policy = policy_of(kinematics)
    for state in states_of(kinematics):
        # slower than the limit, since acceleration counts less than speed
        state = state.with_robot(velocity=0.7 * state.robot.velocity)
        commands = policy.decide(state, TIGHT).commands
        present = kinematics_of(kinematics).present_command(state.robot)[:, None]
        change = commands - present
        if kinematics == 'holonomic':
            assert np.linalg.norm(commands, axis=-1).max() <= 0.8 + 1e-6
            assert np.linalg.norm(change, axis=-1).max() <= 0.1 + 1e-6
        else:
            assert np.abs(commands[..., 0]).max() <= 0.8 + 1e-6
            assert np.abs(commands[..., 1]).max() <= 1.0 and np.abs(change[..., 0]).max() <= 0.1001


@pytest.mark.parametrize('kinematics', KINEMATICS)
def test_what_is_reachable_is_left_as_it_is(kinematics):
    policy = policy_of(kinematics)
    for state in states_of(kinematics):
        present = kinematics_of(kinematics).present_command(state.robot)
        command = policy.act(state, TIGHT)
        again = kinematics_of(kinematics).reachable(command, present, TIGHT, TIGHT.period)
        np.testing.assert_allclose(again, command, rtol=0, atol=1e-12)


def test_a_speed_limit_counts_more_than_the_acceleration():
    fast = np.array([[2.0, 0.0]])
    np.testing.assert_allclose(Holonomic().reachable(fast, fast, TIGHT, 0.1), [[0.8, 0.0]])


def facing_an_obstacle(distance, speed):
    """Return a robot that drives east at an obstacle."""
    state = next(states_of(worlds=1))
    agents = {'position': np.array([[[distance, 0.0]]]), 'velocity': np.zeros((1, 1, 2))}
    placed = state.with_robot(
        position=np.zeros((1, 2)),
        velocity=np.array([[speed, 0.0]]),
        goal=np.array([[9.0, 0.0]]),
    ).with_agents(
        **agents,
        radius=np.full((1, 1), 0.3),
        static=np.ones((1, 1), bool),
        valid=np.ones((1, 1), bool),
    )
    return dataclasses.replace(placed, bounds=np.array([np.inf]))


def safe_from(state, limits):
    """Return the candidates and which of them are safe."""
    config = PolicyConfig()
    wanted = Holonomic().action_set(config)[None]
    commands = Holonomic().reachable(wanted, state.robot.velocity[:, None], limits, 0.1)
    mask = safe_actions(
        state, commands, state.agents.velocity, Holonomic(), config.time_step,
        ScreeningConfig(enabled=True), np.ones((1, 1)), limits=limits, wanted=wanted,
    )  # fmt: skip
    return commands[0], mask[0]


def test_a_robot_that_brakes_slowly_must_brake_early():
    slow = Limits(1.0, 1.0, math.inf, 0.1)
    quick = Limits(1.0, 20.0, math.inf, 0.1)
    state = facing_an_obstacle(1.35, 0.9)
    for limits, may_hurry in ((quick, True), (slow, False)):
        commands, mask = safe_from(state, limits)
        assert mask.any() and (commands[mask, 0].max() > 0.9) == may_hurry


def test_far_away_a_robot_that_brakes_slowly_may_hurry():
    commands, mask = safe_from(facing_an_obstacle(4.0, 0.9), Limits(1.0, 1.0, math.inf, 0.1))
    assert commands[mask, 0].max() > 0.99


LIMITED = {
    'robot_acceleration': 1.0, 'robot_turn_rate': 1.5, 'robot_angular_acceleration': 2.0,
}  # fmt: skip


@pytest.mark.parametrize('kinematics', KINEMATICS)
def test_a_simulated_robot_follows_commands_within_the_limits_of_its_scenario(kinematics):
    scenario = dataclasses.replace(make_scenario('hard'), kinematics=kinematics, **LIMITED)
    simulator, generator = Simulator(scenario, 5), np.random.default_rng(0)
    state = simulator.reset(seed=1)
    for _ in range(12):
        motion, limits = kinematics_of(kinematics), limits_of(scenario)
        before = motion.present_command(state.robot)
        command = generator.normal(scale=3.0, size=(5, 2))
        done = motion.reachable(command, before, limits, limits.period)
        state, _, terminated, truncated, _ = simulator.step(command)
        running = ~(terminated | truncated)
        after = motion.present_command(state.robot)
        np.testing.assert_allclose(after[running], done[running], atol=1e-12)
        assert np.all(np.abs(after - before)[running] <= np.array([0.25, 0.5]) + 1e-9)


def test_a_scenario_without_limits_has_none():
    assert limits_of(make_scenario('hard')) is None
    limited = dataclasses.replace(make_scenario('hard'), robot_turn_rate=1.5)
    assert limits_of(limited) == Limits(1.0, math.inf, 1.5, 0.25, math.inf)


def test_a_turn_rate_changes_no_faster_than_the_limit():
    drive, limits = kinematics_of('differential'), Limits(1.0, 1.0, 1.5, 0.25, 2.0)
    present, wanted = np.array([[0.5, 1.2]]), np.array([[0.6, -1.0], [0.6, 3.0]])
    reached = drive.reachable(wanted, present, limits, 0.25)
    np.testing.assert_allclose(reached, [[0.6, 0.7], [0.6, 1.5]])


def test_evaluation_hands_the_limits_of_the_scenario_to_the_policy():
    scenario = dataclasses.replace(make_scenario('hard'), robot_acceleration=0.8)
    policy = StraightLinePolicy()
    heard = []
    policy.act = lambda state, limits: heard.append(limits) or np.zeros((state.batch_size, 2))
    evaluate(policy, dataclasses.replace(scenario, time_limit=1.0), 2)
    assert set(heard) == {limits_of(scenario)}
