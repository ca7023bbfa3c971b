"""Laws of what a step leads to."""

import numpy as np
import pytest

from socialnav_core.config import RewardConfig
from socialnav_core.simulation.rewards import Outcome, reward_settings, step_outcomes
from socialnav_core.states import Agents, CrowdState, Robot

DURATION = 0.25


def world(position=(3.0, 0.0), velocity=(0.0, 0.0), static=False, goal=(9.0, 0.0), bounds=np.inf):
    """Return one world: robot of radius 0.3 at the origin, one agent of radius 0.3."""
    return CrowdState(
        Robot(
            position=np.zeros((1, 2)),
            velocity=np.zeros((1, 2)),
            heading=np.zeros(1),
            radius=np.array([0.3]),
            preferred_speed=np.ones(1),
            goal=np.array([goal], float),
        ),
        Agents(
            position=np.array([[position]], float),
            velocity=np.array([[velocity]], float),
            radius=np.array([[0.3]]),
            static=np.array([[static]]),
            valid=np.ones((1, 1), bool),
        ),
        bounds=np.array([bounds], float),
        time=np.zeros(1),
    )


def judge(state, displacement=(0.0, 0.0), **reward):
    settings = reward_settings(RewardConfig(**reward), 0.3)
    move = np.array([[displacement]], float)
    result = step_outcomes(state, move, state.agents.velocity, DURATION, settings)
    return [array[0, 0] for array in result]


def test_a_pedestrian_that_passes_through_within_a_step_is_hit():
    # on the left before, on the right after: no overlap at either end
    reward, outcome, clearance, _ = judge(world(position=(-1.0, 0.1), velocity=(8.0, 0.0)))
    assert outcome == Outcome.COLLISION_PEDESTRIAN
    assert reward == -0.25
    assert clearance == pytest.approx(0.1 - 0.6)


def test_an_obstacle_is_told_from_a_pedestrian():
    assert judge(world(position=(0.5, 0.0), static=True))[1] == Outcome.COLLISION_OBSTACLE
    assert judge(world(position=(0.5, 0.0)))[1] == Outcome.COLLISION_PEDESTRIAN


def test_side_by_side_at_equal_speed_keeps_the_distance():
    state = world(position=(0.0, 1.0), velocity=(1.0, 0.0))
    _, outcome, clearance, _ = judge(state, displacement=(0.25, 0.0))
    assert outcome == Outcome.NONE
    assert clearance == pytest.approx(0.4)


def test_discomfort_grows_linearly_below_its_distance():
    reward, outcome, _, _ = judge(world(position=(0.0, 0.75)))
    assert outcome == Outcome.NONE
    assert reward == pytest.approx((0.15 - 0.2) * 0.5 * DURATION)
    assert judge(world(position=(0.0, 0.81)))[0] == 0.0


def test_walls_count_for_discomfort_only_where_they_should():
    state = world(bounds=0.4)
    assert judge(state)[0] == pytest.approx((0.1 - 0.2) * 0.5 * DURATION)
    assert judge(state, walls_discomfort=False)[0] == 0.0


def test_the_rim_behind_a_wall_is_out_of_bounds():
    assert judge(world(bounds=0.5), displacement=(0.19, 0.0))[1] == Outcome.NONE
    assert judge(world(bounds=0.5), displacement=(0.21, 0.0))[1] == Outcome.OUT_OF_BOUNDS


def test_collision_comes_before_out_of_bounds_before_goal():
    hit = world(position=(0.5, 0.0), goal=(0.1, 0.0), bounds=0.2)
    assert judge(hit)[1] == Outcome.COLLISION_PEDESTRIAN
    out = world(goal=(0.1, 0.0), bounds=0.2)
    assert judge(out)[1] == Outcome.OUT_OF_BOUNDS
    reward, outcome, _, _ = judge(world(goal=(0.1, 0.0)))
    assert (reward, outcome) == (1.0, Outcome.GOAL)


def test_the_goal_is_reached_at_the_end_of_a_step_only():
    assert judge(world(goal=(1.0, 0.0)), displacement=(2.0, 0.0))[1] != Outcome.GOAL
    assert judge(world(goal=(1.0, 0.0)), displacement=(0.75, 0.0))[1] == Outcome.GOAL


def test_padding_is_nobody():
    state = world(position=(0.1, 0.0))
    nobody = state.with_agents(valid=np.zeros((1, 1), bool))
    reward, outcome, clearance, pedestrian_clearance = judge(nobody)
    assert (reward, outcome) == (0.0, Outcome.NONE)
    assert np.isinf([clearance, pedestrian_clearance]).all()
