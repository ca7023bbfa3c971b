"""Laws of following a plan; no middleware is needed for them."""

import dataclasses
import math

from helpers.controllers import controller_of, give, Recorder, SECOND, SETTINGS
from helpers.plans import plan_of, read
from helpers.worlds import random_state
import numpy as np
import pytest

from socialnav.control.plan import FOLLOWED, NO_PLAN, PlanFollower
from socialnav_core.sensing import Pose

CORNER = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)]
LOOP = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, -4.0)]


def heading_points(plan, places, ahead=1.0, **options):
    """Return where a robot heads for at each place, one after the other, and the last note."""
    follower, goal = PlanFollower(), np.array(options.pop('goal', (4.0, 4.0)))
    plan = read(plan)
    points = [
        follower.heading_point(plan, np.array(place), goal, ahead, 'odom', **options)
        for place in places
    ]
    return np.array(points), follower.note


def test_the_robot_heads_for_a_point_on_the_plan_that_is_ahead_of_it():
    places = [(0.0, 0.5), (2.0, -0.3), (3.5, 0.0)]
    points, note = heading_points(plan_of(CORNER), places, ahead=2.0)
    np.testing.assert_allclose(points, [(2.0, 0.0), (4.0, 0.0), (4.0, 1.5)])
    assert note == FOLLOWED


def test_at_the_end_of_the_plan_the_robot_heads_for_the_goal_itself():
    points, _ = heading_points(plan_of(CORNER), [(4.0, 3.5)], goal=(4.3, 4.2))
    np.testing.assert_array_equal(points, [(4.3, 4.2)])


def test_a_robot_that_is_pushed_back_is_not_sent_back():
    points, _ = heading_points(plan_of(CORNER), [(2.0, 0.0), (1.0, 0.0), (2.5, 0.0)])
    np.testing.assert_allclose(points, [(3.0, 0.0), (3.0, 0.0), (3.5, 0.0)])


def test_a_plan_that_crosses_itself_is_not_cut_short():
    places = [(x, 0.0) for x in np.arange(0.0, 4.01, 0.5)]
    places += [(4.0, y) for y in np.arange(0.5, 4.01, 0.5)]
    places += [(x, 4.0) for x in np.arange(3.5, -0.01, -0.5)]
    places += [(0.0, y) for y in np.arange(3.5, -0.01, -0.5)]
    points, _ = heading_points(plan_of(LOOP), places, goal=(0.0, -4.0))
    np.testing.assert_allclose(points[0], (1.0, 0.0))
    np.testing.assert_allclose(points[-1], (0.0, -1.0))
    ways = np.hypot(*np.diff(points, axis=0).T)
    assert ways.max() <= 0.5 + 1e-9


def test_a_robot_that_gets_a_plan_half_way_goes_on_from_there():
    points, _ = heading_points(plan_of(CORNER), [(4.2, 2.0)])
    np.testing.assert_allclose(points, [(4.0, 3.0)])


def test_a_new_plan_is_followed_from_where_the_robot_is():
    follower, goal = PlanFollower(), np.array([4.0, 4.0])
    first, second = read(plan_of(CORNER)), read(plan_of([(0.0, 0.0), (0.0, 4.0), (4.0, 4.0)]))
    follower.heading_point(first, np.array([3.0, 0.0]), goal, 1.0, 'odom')
    point = follower.heading_point(second, np.array([0.0, 1.0]), goal, 1.0, 'odom')
    np.testing.assert_allclose(point, (0.0, 2.0))


def test_a_plan_of_one_pose_is_the_goal():
    points, note = heading_points(plan_of([(4.0, 4.0)]), [(0.0, 0.0)])
    np.testing.assert_array_equal(points, [(4.0, 4.0)])
    assert note == FOLLOWED


@pytest.mark.parametrize(
    ('plan', 'reason'),
    [
        (plan_of([]), 'empty'),
        (plan_of([(0.0, 0.0), (math.nan, 1.0), (4.0, 4.0)]), 'position with NaN'),
        (plan_of(CORNER, frame='map'), "in frame 'map'"),
        (plan_of([(0.0, 0.0), (9.0, 4.0)]), '5.00 m from the goal'),
    ],
)
def test_a_plan_that_cannot_be_used_is_ignored_with_a_reason(plan, reason):
    points, note = heading_points(plan, [(0.0, 0.0)])
    np.testing.assert_array_equal(points, [(4.0, 4.0)])
    assert note.startswith('ignored: plan: ') and reason in note


def test_a_pose_of_the_plan_in_another_frame_is_not_used():
    plan = plan_of(CORNER)
    plan.poses[1].header.frame_id = 'base_link'
    assert 'different frames' in heading_points(plan, [(0.0, 0.0)])[1]
    for pose in plan.poses:
        pose.header.frame_id = 'base_link'
    assert "'base_link'" in heading_points(plan, [(0.0, 0.0)])[1]


def test_a_plan_in_a_frame_that_is_known_is_followed_in_the_frame_of_the_robot():
    points, note = heading_points(
        plan_of(CORNER, frame='map'), [(4.0, 0.0)], goal=(0.0, 4.0),
        locate=lambda frame, source, stamp: Pose(4.0, 0.0, math.pi / 2),
    )  # fmt: skip
    np.testing.assert_allclose(points, [(4.0, 1.0)], atol=1e-12)
    assert note == FOLLOWED


def controller_on(plan, **changes):
    """Return a controller with a plan, and what its policy sees."""
    policy, state = Recorder(), random_state(0)
    settings = dataclasses.replace(SETTINGS, plan_lookahead_distance=1.0, **changes)
    controller = controller_of(policy, settings, state=state)
    controller.store('plan', read(plan(state)))
    return controller, policy, state


def straight_plan(state):
    """Return a plan that goes around a corner to the goal."""
    start, goal = state.robot.position[0], state.robot.goal[0]
    return plan_of([tuple(start), (start[0], goal[1]), tuple(goal)])


def test_the_policy_is_given_the_next_point_of_the_plan_for_its_goal():
    controller, policy, state = controller_on(straight_plan)
    assert controller.decide(SECOND).reason is None
    expected = state.robot.position + [[0.0, 1.0]]
    np.testing.assert_allclose(policy.states[0].robot.goal, expected)
    assert controller.plan.note == FOLLOWED


def test_a_run_on_a_plan_ends_at_the_goal_and_not_at_a_point_of_the_plan():
    controller, policy, state = controller_on(straight_plan, goal_tolerance=1.2)
    assert controller.decide(SECOND).reason is None and not controller.goal_reached
    state.robot.position[:] = state.robot.goal + 1.0 / math.sqrt(2)
    give(controller, state, SECOND, without=['goal_pose'])
    assert controller.decide(SECOND).reason == 'goal reached'


def test_a_plan_ages_only_where_that_is_wanted():
    for timeout, note in ((0.0, FOLLOWED), (3.0, 'ignored: plan older than 3 s')):
        controller, policy, state = controller_on(
            lambda state: plan_of([tuple(state.robot.goal[0])], stamp=SECOND), plan_timeout=timeout
        )
        give(controller, state, 9 * SECOND, without=['goal_pose'])
        assert controller.decide(9 * SECOND).reason is None
        assert controller.plan.note == note
        np.testing.assert_array_equal(policy.states[0].robot.goal, state.robot.goal)


def test_without_a_plan_the_goal_is_headed_for():
    policy, state = Recorder(), random_state(0)
    controller = controller_of(policy, state=state)
    controller.decide(SECOND)
    np.testing.assert_array_equal(policy.states[0].robot.goal, state.robot.goal)
    assert controller.plan.note == NO_PLAN
