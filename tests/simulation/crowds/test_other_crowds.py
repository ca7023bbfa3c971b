"""Laws of people who stop, who look at their phones, who walk where they look, and of groups."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import make_scenario
from socialnav_core.evaluation.futures import record_futures
from socialnav_core.simulation import Simulator
from socialnav_core.simulation.crowds.distracted import SHARE
from socialnav_core.simulation.crowds.forces import limited_accelerations, social_accelerations
from socialnav_core.simulation.crowds.headed_social_force import moved, Walk
from socialnav_core.simulation.crowds.social_force import Force
from socialnav_core.simulation.crowds.social_force_kernel import social_force_step
from socialnav_core.simulation.crowds.stop_and_go import PAUSES
from socialnav_core.states import Agents

NEW = ('stop_and_go', 'distracted', 'headed_social_force', 'groups')
AWAY = 500.0


def world_of(crowd, name='crowd20', **changes):
    return dataclasses.replace(make_scenario(name), crowd=crowd, bounds=1000.0, **changes)


def watched(scenario, steps=80, worlds=8, robot=AWAY):
    """Return a simulator that has run, and the states."""
    simulator = Simulator(scenario, worlds, 'disabled')
    states = [simulator.reset()]
    simulator._episodes.state.robot.position[:] = robot
    simulator._episodes.state.robot.goal[:] = -AWAY
    for _ in range(steps):
        states.append(simulator.step(np.zeros((worlds, 2)))[4]['final_state'])
    return simulator, states


def velocities(states):
    """Return the velocities of people, (moments, worlds, people, 2)."""
    return np.array([state.agents.velocity[:, :20] for state in states])


@pytest.mark.parametrize('crowd', NEW)
def test_what_people_will_do_is_known_bit_by_bit(crowd):
    scenario = world_of(crowd, 'hard')
    futures = record_futures(scenario, np.array([3, 5]), 2, 'test')
    simulator = Simulator(scenario, 2, autoreset='disabled')
    state = simulator.reset(seed=2, cases=[3, 5])
    for step in range(30):
        if not simulator.active.all():
            break
        np.testing.assert_array_equal(futures.position[:, step], state.agents.position)
        state = simulator.step(np.zeros((2, 2)))[0]
    assert step > 5


@pytest.mark.parametrize('crowd', NEW)
def test_a_simulation_goes_on_from_its_state(crowd):
    one, other = Simulator(world_of(crowd), 4), Simulator(world_of(crowd), 4)
    one.reset()
    other.reset(seed=7)
    for _ in range(15):
        one.step(np.zeros((4, 2)))
    other.set_state(one.get_state())
    for _ in range(15):
        state, copy = (each.step(np.zeros((4, 2)))[0] for each in (one, other))
        np.testing.assert_array_equal(state.agents.position, copy.agents.position)


@pytest.mark.parametrize('crowd', NEW)
def test_looking_ahead_changes_nothing(crowd):
    one, other = Simulator(world_of(crowd), 3), Simulator(world_of(crowd), 3)
    one.reset()
    other.reset()
    for _ in range(8):
        assert one.foresee(5).shape == (3, 5, 20, 2)
        state, copy = (each.step(np.zeros((3, 2)))[0] for each in (one, other))
        np.testing.assert_array_equal(state.agents.position, copy.agents.position)


@pytest.mark.parametrize('crowd', NEW)
def test_people_who_see_the_robot_keep_away_from_it(crowd):
    left = []
    for visible in (False, True):
        scenario = world_of(crowd, robot_visible=visible, pedestrians=8)
        simulator, _ = watched(scenario, steps=40, worlds=60, robot=0.0)
        left.append(simulator.active.mean())  # the robot has not been run over
    assert left[1] > left[0] + 0.05, left


def test_people_stop_all_of_a_sudden_and_go_on():
    _, states = watched(world_of('stop_and_go'))
    speed = np.linalg.norm(velocities(states), axis=-1)
    assert 0.1 < (speed[8:] == 0.0).mean() < 0.4
    stops = (speed[2:] == 0.0) & (speed[1:-1] > 0.6)
    assert stops.sum() > 50  # from a walk to nothing within a step
    standing = 0
    for moment in (speed[:, 0, :] == 0.0).T:
        runs = np.diff(np.flatnonzero(np.diff(np.r_[False, moment[1:], False])))[::2]
        standing = max(standing, runs.max(initial=0))
    assert standing * 0.25 <= 2.0 * PAUSES[1]


def test_some_people_walk_straight_on_and_the_others_avoid_them():
    simulator, states = watched(world_of('distracted', renew_goals=False), steps=20, worlds=40)
    blind = simulator._crowd.get_state()['blind']
    assert blind.mean() == pytest.approx(SHARE, abs=0.06)
    begin, goal = states[0].agents.position, simulator.get_state()['goal']
    way = goal - begin
    way /= np.linalg.norm(way, axis=-1, keepdims=True)
    moved = states[-1].agents.position - begin
    aside = np.abs(moved[..., 0] * way[..., 1] - moved[..., 1] * way[..., 0])
    assert aside[blind].max() < 1e-9 and np.median(aside[~blind]) > 0.05


def test_forces_are_those_of_the_crowd_social_force():
    generator = np.random.default_rng(0)
    position, motion, preferred = generator.uniform(-2.0, 2.0, (3, 2, 6, 2))
    radius = np.full((2, 6), 0.3)
    every = np.ones((2, 6), bool)
    agents = Agents(position, motion, radius, ~every, every)
    force = social_accelerations(position, agents, radius, preferred)
    force += (preferred - motion) / Force().relaxation
    out = np.empty_like(position)
    social_force_step(
        position, motion, preferred, radius, np.full((2, 6), 100.0), 6, *Force(), 0.05, out
    )
    np.testing.assert_allclose(out, motion + 0.05 * limited_accelerations(force))


def test_who_walks_where_they_look_moves_sideways_little():
    simulator, states = watched(world_of('headed_social_force'), steps=40)
    heading = simulator._crowd.get_state()['heading']
    velocity = states[-1].agents.velocity
    sideways = np.abs(velocity[..., 1] * np.cos(heading) - velocity[..., 0] * np.sin(heading))
    forwards = velocity[..., 0] * np.cos(heading) + velocity[..., 1] * np.sin(heading)
    assert np.mean(sideways) < 0.25 * np.mean(np.abs(forwards))


def test_who_walks_where_they_look_does_not_go_on_sideways():
    motion = np.array([[[1.0, 0.5]]])
    walk = Walk(np.zeros((1, 1, 2)), motion, np.zeros((1, 1)), np.zeros((1, 1)))
    for _ in range(12):
        walk = moved(
            walk, np.array([[[1.0, 0.0]]]), np.zeros((1, 1, 2)), np.full((1, 1), 3.0), 0.05
        )
    left = np.array([-np.sin(walk.heading), np.cos(walk.heading)])[:, 0, 0]
    assert abs(left @ walk.motion[0, 0]) < 0.05


def test_groups_have_two_to_four_members_who_start_side_by_side_and_stay_together():
    simulator, states = watched(world_of('groups'), steps=80, worlds=20)
    leaders = simulator._crowd.get_state()['leaders']
    sizes = np.concatenate([np.bincount(row)[np.unique(row)] for row in leaders])
    assert sizes.max() <= 4 and (sizes == 1).mean() < 0.15  # one may be left over in a world
    worlds = np.arange(20)[:, None]
    apart = [
        np.linalg.norm(state.agents.position - state.agents.position[worlds, leaders], axis=-1)
        for state in (states[0], states[-1])
    ]
    followers = leaders != np.arange(20)
    strangers = np.linalg.norm(
        states[-1].agents.position[:, :, None] - states[-1].agents.position[:, None], axis=-1
    )
    for distance in apart:
        assert np.median(distance[followers]) < 1.5 < np.median(strangers)
    goals = simulator.get_state()['goal']
    np.testing.assert_array_equal(goals, goals[worlds, leaders])


def test_groups_get_other_goals_together():
    simulator, _ = watched(world_of('groups', time_limit=200.0), steps=0, worlds=6)
    before = simulator.get_state()['goal']
    for _ in range(200):
        simulator.step(np.zeros((6, 2)))
    after = simulator.get_state()['goal']
    assert (before != after).any(axis=-1).mean() > 0.8


def test_somebody_alone_walks_as_in_the_crowd_social_force():
    paths = []
    for crowd in ('groups', 'social_force'):
        _, states = watched(
            world_of(crowd, 'hard', pedestrians=1, renew_goals=False), steps=30, worlds=4
        )
        paths.append(np.array([state.agents.position[:, 0] for state in states]))
    np.testing.assert_allclose(*paths, atol=1e-6)
