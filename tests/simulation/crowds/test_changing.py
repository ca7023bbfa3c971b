"""Laws of the crowd whose people come, change their goals and go."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.evaluation import evaluate, find_bounds
from socialnav_core.metrics import METRICS
from socialnav_core.policies import StraightLinePolicy
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.simulation.births import GAP

WORLD = make_scenario('crowd20_random')
ENDLESS = dataclasses.replace(WORLD, time_limit=60.0)


def watched(steps=140, worlds=4, **reset):
    """Return the states of worlds whose robots stand where nobody comes, and the goals."""
    simulator = Simulator(ENDLESS, worlds, autoreset='disabled')
    states, goals = [simulator.reset(**reset)], [simulator._episodes.goal.copy()]
    simulator._episodes.state.robot.position[:] = 50.0
    for _ in range(steps):
        states.append(simulator.step(np.zeros((worlds, 2)))[4]['final_state'])
        goals.append(simulator._episodes.goal.copy())
    return states, np.array(goals)


STATES, GOALS = watched()
POSITION = np.array([state.agents.position for state in STATES])
RADIUS = np.array([state.agents.radius for state in STATES])
JUMPS = np.linalg.norm(np.diff(POSITION, axis=0), axis=-1) > 0.5


def test_the_robot_crosses_the_square_between_far_apart_points():
    robot = Simulator(WORLD, 200).reset().robot
    travel = np.linalg.norm(robot.goal - robot.position, axis=1)
    assert travel.min() >= 8.0 and 9.6 < travel.mean() < 10.3
    assert max(np.abs(robot.goal).max(), np.abs(robot.position).max()) <= 6.0


def test_people_begin_around_the_square_clear_of_each_other_and_head_for_the_other_side():
    simulator = Simulator(WORLD, 50)
    state = simulator.reset()
    place, radius = state.agents.position, state.agents.radius
    np.testing.assert_array_equal(simulator._episodes.goal, -place)
    away = np.linalg.norm(place - 1.0, axis=-1)
    assert (np.abs(away - 6.0 * np.sqrt(2.0)) <= np.sqrt(2.0) + 1e-9).all()
    between = np.linalg.norm(place[:, :, None] - place[:, None], axis=-1)
    keep = radius[:, :, None] + radius[:, None] + GAP
    between[:, np.arange(20), np.arange(20)] = np.inf
    assert (between >= keep).all()


def test_people_differ_in_size_and_speed():
    assert 0.3 <= RADIUS.min() < 0.33 and 0.47 < RADIUS.max() <= 0.5
    speed = np.linalg.norm([state.agents.velocity for state in STATES], axis=-1)
    assert 1.0 < speed.max() <= 1.5 + 1e-6


def test_whoever_arrives_is_replaced_by_somebody_else():
    assert JUMPS.any()
    after = RADIUS[1:][JUMPS]
    assert (after != RADIUS[:-1][JUMPS]).all()
    assert not np.diff(RADIUS, axis=0)[~JUMPS].any()


def test_nobody_comes_where_somebody_is():
    for step, world, person in np.argwhere(JUMPS):
        place, radius = POSITION[step + 1, world], RADIUS[step + 1, world]
        gap = np.linalg.norm(place - place[person], axis=-1) - radius - radius[person]
        others = np.delete(gap, person)
        newcomers = JUMPS[step, world].sum()
        assert others.min() >= GAP - 1e-9 or newcomers > 1


def test_about_half_of_the_people_change_their_goal_every_five_seconds_and_at_no_other_time():
    changed = (np.diff(GOALS, axis=0) != 0).any(axis=-1) & ~JUMPS
    times = np.array([state.time for state in STATES[1:]])
    due = np.isclose(times % 5.0, 0.0) | np.isclose(times % 5.0, 5.0)
    assert not changed[~due].any()
    shares = changed.mean(axis=2)[due & (np.arange(len(times)) < 130)[:, None]]
    assert 0.35 < shares.mean() < 0.65


def test_a_run_that_is_continued_goes_on_in_the_same_way():
    one, other = Simulator(WORLD, 3), Simulator(WORLD, 3)
    one.reset(seed=1)
    for _ in range(25):
        one.step(np.zeros((3, 2)))
    other.reset(seed=5)
    other.set_state(one.get_state())
    for _ in range(25):
        first, second = (each.step(np.zeros((3, 2)))[0] for each in (one, other))
        np.testing.assert_array_equal(first.agents.position, second.agents.position)


def test_what_is_foreseen_comes_about_and_looking_changes_nothing():
    looking, blind = Simulator(WORLD, 4), Simulator(WORLD, 4)
    for simulator in (looking, blind):
        simulator.reset(seed=2)
    foreseen = looking.foresee(3)
    for step in range(3):
        state, other = (each.step(np.zeros((4, 2)))[0] for each in (looking, blind))
        np.testing.assert_array_equal(state.agents.position, other.agents.position)
        np.testing.assert_array_equal(state.agents.position, foreseen[:, step])


def test_intrusions_are_foreseen_only_where_that_is_asked_for():
    metric = METRICS['foreseen_intrusion_rate']
    plain = evaluate(StraightLinePolicy(), WORLD, 12)
    asked = evaluate(StraightLinePolicy(), WORLD, 12, foresight=True)
    assert metric.figure(plain.records) is None
    assert 0.0 < metric.figure(asked.records) < 1.0
    np.testing.assert_array_equal(plain.records.time, asked.records.time)


def test_people_who_are_to_see_the_robot_are_refused():
    with pytest.raises(ConfigError, match='does not see the robot'):
        Simulator(dataclasses.replace(WORLD, robot_visible=True), 1)


def test_people_come_where_no_obstacle_is():
    cluttered = dataclasses.replace(WORLD, obstacles=3, obstacle_radius_max=1.0)
    agents = Simulator(cluttered, 30).reset().agents
    people, things = agents.position[:, :20, None], agents.position[:, None, 20:]
    keep = agents.radius[:, :20, None] + agents.radius[:, None, 20:] + GAP
    assert (np.linalg.norm(people - things, axis=-1) >= keep).all()


def test_there_is_no_bound_where_people_depend_on_the_robot():
    with pytest.raises(ConfigError, match='no bound'):
        find_bounds(WORLD, np.arange(1))


@pytest.mark.slow
def test_the_world_is_as_hard_as_the_one_that_it_is_made_after():
    """Figures of 500 episodes each in the code of CrowdNav++, with a margin of .05."""
    from socialnav_core.policies import OrcaPolicy

    blind = evaluate(StraightLinePolicy(), WORLD, 500)
    orca = evaluate(OrcaPolicy(), WORLD, 500, foresight=True)
    assert abs(blind.success_rate - 0.126) < 0.05
    assert abs(orca.success_rate - 0.824) < 0.05
    assert abs(METRICS['foreseen_intrusion_rate'].figure(orca.records) - 0.19) < 0.05
