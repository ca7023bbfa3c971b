"""Laws of the starts of episodes."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.simulation import make_scenario, PackingError, Simulator

TOLERANCE = 1e-12


def start(name, worlds=200, **settings):
    scenario = dataclasses.replace(make_scenario(name), **settings)
    simulator = Simulator(scenario, worlds)
    return scenario, simulator.reset(seed=5, split='train'), simulator


def gaps(state):
    """Return the gaps between the rims of all pairs of agents, inf for an agent and itself."""
    offsets = state.agents.position[:, :, None] - state.agents.position[:, None]
    distance = np.linalg.norm(offsets, axis=-1)
    gap = distance - state.agents.radius[:, :, None] - state.agents.radius[:, None]
    return gap + np.where(np.eye(state.agents.count, dtype=bool), np.inf, 0.0)


@pytest.mark.parametrize('name', ['simple', 'hard', 'crowd20', 'curriculum-2.5', 'packed-2.5'])
def test_nobody_starts_nearer_than_the_gap(name):
    scenario, state, _ = start(name)
    assert gaps(state).min() >= 0.2 - TOLERANCE
    to_robot = np.linalg.norm(state.agents.position - state.robot.position[:, None], axis=-1)
    to_robot -= state.agents.radius + scenario.robot_radius
    assert to_robot[:, : scenario.pedestrians].min() >= 0.2 - TOLERANCE
    if scenario.obstacles:
        assert to_robot[:, scenario.pedestrians :].min() >= 1.2 - TOLERANCE
        between = gaps(state)[:, scenario.pedestrians :, scenario.pedestrians :]
        assert between.min() >= 1.2 - TOLERANCE


def test_the_goal_lies_on_the_circle_and_outside_of_obstacles():
    scenario, state, _ = start('hard')
    assert np.linalg.norm(state.robot.goal, axis=-1) == pytest.approx(5.0)
    distance = (
        np.linalg.norm(state.agents.position - state.robot.goal[:, None], axis=-1)
        - state.agents.radius
    )
    assert distance[:, scenario.pedestrians :].min() >= 0.2 - TOLERANCE


def test_the_robot_travels_as_far_as_the_report_says():
    _, state, _ = start('simple', worlds=4000)
    offset = np.abs(state.robot.goal - state.robot.position)
    assert offset.max(axis=-1).min() > 7.5
    assert np.linalg.norm(offset, axis=-1).mean() == pytest.approx(9.5, abs=0.1)


def test_pedestrians_cross_to_the_other_side():
    _, state, simulator = start('simple')
    goal = simulator.get_state()['goal'][:, :5]
    assert (state.agents.position[:, :5, 0] * goal[..., 0] <= 0).all()
    assert (state.agents.position[:, :5, 0] > 0).mean() == pytest.approx(0.5, abs=0.1)


def test_the_hardest_share_of_the_obstacles_has_the_largest_radius():
    _, state, _ = start('curriculum-1.7')
    radius = state.agents.radius[:, 5:]
    assert (radius[:, :2] == 1.7).all()
    assert ((radius[:, 2:] >= 0.3) & (radius[:, 2:] < 1.7)).all()


def test_randomized_pedestrians_differ_in_size_and_speed():
    _, state, simulator = start('crowd20', randomize_attributes=True)
    speed = simulator.get_state()['preferred_speed']
    assert 0.3 <= state.agents.radius.min() < 0.31 and 0.49 < state.agents.radius.max() < 0.5
    assert 0.5 <= speed.min() < 0.51 and 1.49 < speed.max() < 1.5


@pytest.mark.parametrize(
    'settings',
    [
        {'obstacle_radius_min': 3.0, 'obstacle_radius_max': 3.0},
        {'pedestrians': 400},
        {'minimum_travel': 50.0},
    ],
)
def test_a_world_that_cannot_be_packed_is_an_error_that_names_the_settings(settings):
    with pytest.raises(PackingError, match='spawn_half_width'):
        start('hard', worlds=1, **settings)


def test_the_circle_is_crossed_as_in_crowdnav():
    scenario, state, simulator = start('circle')
    assert (state.robot.position == (0.0, -4.0)).all() and (state.robot.goal == (0.0, 4.0)).all()
    assert np.allclose(simulator.get_state()['goal'], -state.agents.position)
    assert np.isinf(state.bounds).all()
