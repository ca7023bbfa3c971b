"""Laws of the search for a differential drive, as a policy."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError, DifferentialConfig, make_scenario, SearchConfig
from socialnav_core.policies import load_policy, SearchPolicy
from socialnav_core.policies.search.differential.policy import DifferentialSearchPolicy
from socialnav_core.simulation import Simulator
from socialnav_core.simulation.kinematics import Limits
from tests.policies.search.differential.differential_worlds import (
    DRIVE,
    drive,
    facing,
    LIMITS,
    moved,
)
from tests.policies.search.search_worlds import discs, distance_to_goal, gaps, STEP


@pytest.fixture(scope='module')
def policy():
    return DifferentialSearchPolicy()


def crowd(policy, name='hard', worlds=6, steps=8):
    """Return worlds of a scenario under way."""
    scenario = dataclasses.replace(make_scenario(name), kinematics='differential')
    simulator = Simulator(scenario, worlds)
    state = simulator.reset(seed=2, split='train')
    for _ in range(steps):
        state, *_ = simulator.step(policy.act(state, LIMITS))
    return state


def least_time(distance):
    """Return how long a straight way takes from rest, s."""
    return distance + 0.5 if distance > 0.5 else np.sqrt(2 * distance)


@pytest.mark.parametrize('tolerance', [0.1, 0.15, 0.3])
@pytest.mark.parametrize('goal', [(0.6, 0.0), (5.0, 1.0), (30.0, 0.0)])
def test_alone_it_takes_little_more_than_the_time_of_the_straight_line(policy, goal, tolerance):
    states, _ = drive(policy, facing(goal=goal), tolerance=tolerance)
    assert distance_to_goal(states[-1]) < tolerance
    least = least_time(np.hypot(*goal) - tolerance)
    assert (len(states) - 1) * STEP <= 1.05 * least + 4 * STEP


@pytest.mark.parametrize('bearing', [0.5, 1.5, 2.5, 3.1, -1.0, -3.1])
@pytest.mark.parametrize('distance', [0.6, 1.5, 6.0])
def test_it_reaches_a_goal_wherever_it_looks(policy, bearing, distance):
    states, _ = drive(policy, facing(heading=bearing, goal=(distance, 0.0)), tolerance=0.15)
    assert distance_to_goal(states[-1]) < 0.15
    turning = abs(bearing) / LIMITS.turn_rate + 0.75
    assert (len(states) - 1) * STEP <= turning + least_time(distance) + 2.0


def test_it_turns_on_the_spot_towards_a_goal_behind(policy):
    states, commands = drive(policy, facing(heading=np.pi - 0.01, goal=(4.0, 0.0)))
    turned = np.abs(np.cumsum(commands[:, 1]) * STEP)
    assert commands[turned < 1.0, 0].max() < 0.3
    assert np.all(commands[:, 0] >= 0.0)
    turns = commands[np.abs(commands[:, 1]) > 0.2, 1]
    assert len(set(np.sign(turns))) == 1  # one way around
    assert distance_to_goal(states[-1]) < 0.3


def test_alone_it_drives_smoothly(policy):
    _, commands = drive(policy, facing(heading=0.4, goal=(8.0, 0.0)))
    changes = np.diff(commands[:, 1])
    changes = changes[np.abs(changes) > 0.1]
    assert np.count_nonzero(np.diff(np.sign(changes))) <= 1  # into the turn and out of it
    assert np.all(np.diff(commands[:, 0]) >= -1e-9)


@pytest.mark.parametrize('limits', [
    Limits(0.5, 0.3, 0.6, 0.1, 0.8), Limits(1.0, 4.0, 3.0, 0.2, 9.0),
    Limits(1.0, 1.0, 1.5, 0.5, 2.0),
])  # fmt: skip
def test_it_keeps_to_whatever_limits_it_is_given(limits):
    policy = DifferentialSearchPolicy()
    walker = discs((3.0, 0.2, 0.3), velocity=[(-0.5, 0.0)])
    states, commands = drive(policy, facing(heading=1.0, agents=walker), limits, steps=300)
    assert distance_to_goal(states[-1]) < 0.3
    assert np.abs(commands[:, 0]).max() <= limits.speed * (1 + 1e-9)
    assert np.abs(commands[:, 1]).max() <= limits.turn_rate * (1 + 1e-9)


def test_without_limits_it_keeps_to_those_of_its_settings():
    own = DifferentialConfig(acceleration=0.5, turn_rate=0.8, angular_acceleration=1.0)
    policy = DifferentialSearchPolicy(SearchConfig(kinematics='differential', differential=own))
    state = facing(heading=2.0)
    for _ in range(12):
        command = policy.act(state)
        change = np.abs(command - DRIVE.present_command(state.robot))[0]
        assert np.all(change <= np.array([0.5, 1.0]) * STEP + 1e-9)
        assert abs(command[0, 1]) <= 0.8 + 1e-9
        state = moved(state, command, STEP)


def test_a_robot_beyond_its_limits_comes_back_within_them(policy):
    command = policy.act(facing(speed=3.0, turn_rate=4.0), LIMITS)[0]
    assert command[0] <= 1.0 and abs(command[1]) <= 1.5


def test_a_robot_that_may_not_turn_drives_straight_on(policy):
    command = policy.act(facing(speed=0.5), Limits(1.0, 1.0, 0.0, STEP, 2.0))[0]
    assert command[0] > 0.5 and abs(command[1]) < 1e-5


def test_it_never_drives_backwards_unless_it_may(policy):
    goal = {'heading': np.pi, 'goal': (0.7, 0.0)}
    _, commands = drive(policy, facing(**goal))
    assert commands[:, 0].min() >= 0.0
    own = DifferentialConfig(reverse=1.0)
    backwards = DifferentialSearchPolicy(SearchConfig(kinematics='differential', differential=own))
    _, commands = drive(backwards, facing(**goal))
    assert commands[:, 0].min() < 0.0


def test_it_stops_before_somebody_who_stands_in_a_corridor(policy):
    sides = [(x, y, 0.5) for x in np.arange(0.0, 8.1, 0.5) for y in (-0.9, 0.9)]
    people = discs((4.0, 0.0, 0.3))
    corridor = people.append(discs(*sides, static=True))
    states, commands = drive(policy, facing(agents=corridor, goal=(7.0, 0.0), speed=0.9), steps=40)
    assert min(gaps(state).min() for state in states) > 0.0
    assert abs(commands[-1, 0]) < 0.05
    assert states[-1].robot.position[0, 0] > 1.5


@pytest.mark.parametrize('radius', [0.3, 1.5])
def test_it_drives_around_an_obstacle_without_touching_it_on_its_arcs(policy, radius):
    obstacle = discs((4.0, 0.05, radius), static=True)
    states, commands = drive(policy, facing(agents=obstacle, goal=(8.0, 0.0)))
    assert distance_to_goal(states[-1]) < 0.3
    for state, command in zip(states, commands, strict=False):
        arc = [moved(state, command[None], share * STEP) for share in np.linspace(0, 1, 11)]
        assert min(gaps(place).min() for place in arc) >= 0.0


def test_a_robot_that_drives_at_a_wall_brakes_in_time(policy):
    state = facing(speed=1.0, goal=(9.0, 0.0), bounds=2.0)
    states, _ = drive(policy, state, steps=30)
    assert max(np.abs(state.robot.position).max() for state in states) <= 1.7


def test_somebody_who_walks_head_on_is_passed(policy):
    walker = discs((7.0, 0.1, 0.3), velocity=[(-1.0, 0.0)])
    states, _ = drive(policy, facing(agents=walker, goal=(8.0, 0.0)))
    assert distance_to_goal(states[-1]) < 0.3
    assert min(gaps(state)[0] for state in states) > 0.05


def test_the_plan_begins_with_what_the_command_does(policy):
    state = crowd(policy)
    command = policy.act(state, LIMITS)
    displacement, _, _ = DRIVE.move(state.robot.heading, command, LIMITS.period)
    np.testing.assert_allclose(policy.plan[:, 0], state.robot.position + displacement, atol=1e-9)
    assert policy.times[0] == LIMITS.period and len(policy.times) == policy.plan.shape[1]
    steps = np.linalg.norm(np.diff(policy.plan, axis=1), axis=-1)
    assert np.all(steps <= np.diff(policy.times) * LIMITS.speed * (1 + 1e-9))


@pytest.mark.parametrize('name', ['hard', 'crowd20'])
def test_a_batch_is_its_worlds_one_by_one(policy, name):
    state = crowd(policy, name)
    together, alone = policy.act(state, LIMITS), DifferentialSearchPolicy()
    apart = [alone.act(state.select(np.array([i])), LIMITS)[0] for i in range(state.batch_size)]
    assert np.array_equal(together, apart)
    assert np.array_equal(together, policy.act(state, LIMITS))


def test_turning_the_world_turns_the_plan(policy):
    state = facing(heading=0.3, agents=discs((2.0, 0.4, 0.3)), goal=(6.0, 1.0))
    turn = np.array([[0.0, 1.0], [-1.0, 0.0]])  # by a quarter, for row vectors
    turned = state.with_robot(
        heading=state.robot.heading + np.pi / 2, goal=state.robot.goal @ turn
    ).with_agents(position=state.agents.position @ turn)
    commands = [policy.act(one, LIMITS) for one in (state, turned)]
    np.testing.assert_allclose(commands[0], commands[1], atol=1e-6)


def test_it_is_found_by_the_kinematics():
    assert isinstance(load_policy('search', kinematics='differential'), DifferentialSearchPolicy)
    assert load_policy('search').description.kinematics == 'holonomic'
    for kind, other in ((SearchPolicy, 'differential'), (DifferentialSearchPolicy, 'holonomic')):
        with pytest.raises(ConfigError, match='kinematics'):
            kind(SearchConfig(kinematics=other))


@pytest.mark.parametrize('setting', [
    {'acceleration': 0.0}, {'beam': 0}, {'slack': -1.0}, {'headings': 3}, {'reverse': 1.5},
    {'arc_share': 1.1},
])  # fmt: skip
def test_settings_that_describe_no_base_or_search_are_refused(setting):
    with pytest.raises(ConfigError, match='must lie in'):
        DifferentialConfig(**setting)
