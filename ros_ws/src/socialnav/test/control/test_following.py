"""Laws of how following a path ends; no middleware is needed for them."""

import dataclasses
import math

from geometry_msgs.msg import PoseStamped
from helpers.controllers import controller_of, give, SECOND, SETTINGS
from helpers.plans import plan_of, read
from helpers.worlds import quaternion_of, random_state
import numpy as np
import pytest

from socialnav.control.decisions import Decision, NO_COMMAND
from socialnav.control.following import Code, Following, REACHED, refusal, same_end
from socialnav.control.reasons import Cause
from socialnav.messages.follow_requests import FollowRequest
from socialnav.messages.stamps import header_message

DRIVES = Decision(np.array([0.5, 0.0]))
TICK = SECOND // 10
PATIENT = dataclasses.replace(SETTINGS, failure_tolerance=0.3, progress_timeout=2.0)
TURNING = dataclasses.replace(SETTINGS, goal_yaw_tolerance=0.2)


def request_of(points, yaw=0.0, frame='odom', **names):
    """Return a request to follow a path through points."""
    end = PoseStamped(header=header_message(SECOND, frame))
    if len(points):
        end.pose.position.x, end.pose.position.y = map(float, points[-1])
    end.pose.orientation = quaternion_of(yaw)
    return FollowRequest(read(plan_of(points, frame=frame)), end, **names)


def standing(cause):
    """Return a decision to stand."""
    return Decision(NO_COMMAND, 'because', cause=cause)


def ends(decisions, settings=PATIENT, states=None):
    """Return (tick, code) with which following ends; None where it does not."""
    following = Following(0)
    for tick, decision in enumerate(decisions, 1):
        state = states[tick - 1] if states else random_state(tick)
        outcome = following.look(decision, state, tick * TICK, settings)
        if outcome is not None:
            return tick, outcome.code
    return None


@pytest.mark.parametrize(
    ('cause', 'code'),
    [
        (Cause.INPUT, Code.CONTROLLER_TIMED_OUT),
        (Cause.FRAME, Code.TF_ERROR),
        (Cause.CONTROL, Code.PATIENCE_EXCEEDED),
    ],
)
def test_a_reason_to_stand_is_a_failure_once_it_has_lasted_for_the_tolerance(cause, code):
    assert ends([standing(cause)] * 10) == (3, code)
    assert ends([standing(cause), standing(cause), DRIVES] * 10) is None
    endless = dataclasses.replace(PATIENT, failure_tolerance=-1.0)
    assert ends([standing(cause)] * 100, endless) is None


def test_without_tolerance_the_first_failure_is_the_last():
    impatient = dataclasses.replace(PATIENT, failure_tolerance=0.0)
    assert ends([DRIVES, standing(Cause.CONTROL)], impatient) == (2, Code.NO_VALID_CONTROL)
    assert ends([DRIVES, standing(Cause.INPUT)], impatient) == (2, Code.CONTROLLER_TIMED_OUT)


@pytest.mark.parametrize(
    ('cause', 'code'),
    [
        (Cause.ARRIVED, Code.NONE),
        (Cause.NO_GOAL, Code.UNKNOWN),
        (Cause.PROGRESS, Code.FAILED_TO_MAKE_PROGRESS),
    ],
)
def test_what_waiting_does_not_change_ends_it_at_once(cause, code):
    assert ends([DRIVES, standing(cause)]) == (2, code)


def moved(metres=0.0, turned=0.0):
    """Return a robot elsewhere."""
    state = random_state(0)
    state.robot.position[0, 0] += metres
    state.robot.heading += turned
    return state


def test_a_robot_that_stays_within_a_circle_makes_no_progress():
    wobbling = [moved(0.2 * (tick % 3)) for tick in range(30)]
    assert ends([DRIVES] * 30, states=wobbling) == (21, Code.FAILED_TO_MAKE_PROGRESS)


@pytest.mark.parametrize('motion', [{'metres': 0.03}, {'turned': 0.03}])
def test_a_robot_that_moves_or_turns_slowly_makes_progress(motion):
    states = [moved(**{name: tick * step for name, step in motion.items()}) for tick in range(99)]
    assert ends([DRIVES] * 99, states=states) is None


def test_a_clock_that_jumps_does_not_end_it():
    following, state = Following(0), moved()
    assert following.look(DRIVES, state, 1000 * SECOND, PATIENT) is None
    assert following.look(DRIVES, state, 0, PATIENT) is None


STRAIGHT = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]


@pytest.mark.parametrize(
    ('request_', 'code'),
    [
        (request_of([]), Code.INVALID_PATH),
        (request_of([(0.0, math.nan)]), Code.INVALID_PATH),
        (request_of([(0.0, 1e12)]), Code.INVALID_PATH),
        (request_of(STRAIGHT, controller_id='MPPI'), Code.INVALID_CONTROLLER),
        (request_of(STRAIGHT, goal_checker_id='precise'), Code.UNKNOWN),
        (request_of(STRAIGHT, progress_checker_id='pose'), Code.UNKNOWN),
    ],
)
def test_a_request_that_cannot_be_followed_is_refused_with_the_reason(request_, code):
    outcome = refusal(request_, SETTINGS)
    assert outcome.code is code and outcome.text


def test_a_request_that_names_nobody_or_whom_the_parameters_name_is_followed():
    names = {
        'controller_id': 'FollowPath', 'goal_checker_id': 'general_goal_checker',
        'progress_checker_id': 'progress_checker',
    }  # fmt: skip
    assert refusal(request_of(STRAIGHT), SETTINGS) is None
    assert refusal(request_of(STRAIGHT, **names), SETTINGS) is None


def test_a_path_that_is_too_long_is_refused():
    long = request_of(STRAIGHT)
    path = dataclasses.replace(long.path, points=np.zeros((100_001, 2)))
    assert refusal(dataclasses.replace(long, path=path), SETTINGS).code is Code.INVALID_PATH


def test_an_orientation_that_is_none_is_refused_only_where_it_counts():
    request = request_of(STRAIGHT)
    request.end.pose.orientation.w = 0.0
    assert refusal(request, SETTINGS) is None
    assert refusal(request, TURNING).code is Code.INVALID_PATH


def test_the_end_is_the_same_where_frame_and_pose_are():
    one = request_of(STRAIGHT)
    assert same_end(one, request_of([(0.5, 0.1), (2.0, 0.0)]))
    for other in (request_of([(2.0, 0.1)]), request_of(STRAIGHT, 1.0),
                  request_of(STRAIGHT, frame='map')):  # fmt: skip
        assert not same_end(one, other)


def test_another_way_to_the_same_goal_begins_no_new_run_and_another_goal_does(policy):
    controller = controller_of(policy, without=['goal_pose'])
    for points, same, runs in (
        (STRAIGHT, False, 1), ([(0.2, 0.1), (2.0, 0.0)], True, 1), (STRAIGHT, False, 2),
    ):  # fmt: skip
        now = SECOND + runs
        controller.follow(request_of(points), now, same_goal=same)
        give(controller, random_state(0), now, without=['goal_pose'])
        assert controller.decide(now).reason is None
        assert policy.resets == runs and controller.plan.note == 'followed'


def test_the_way_that_is_left_is_that_along_the_path(policy):
    state = random_state(0)
    state.robot.position[:] = 0.0
    controller = controller_of(policy, state=state, without=['goal_pose'])
    assert controller.distance_left() == 0.0
    detour = [(0.0, 0.0), (0.0, 3.0), (4.0, 3.0)]
    controller.follow(request_of(detour), SECOND, same_goal=False)
    controller.decide(SECOND)
    assert controller.distance_left() == pytest.approx(7.0)


def test_a_robot_that_rests_is_silent_until_there_is_another_goal(policy):
    controller = controller_of(policy)
    assert controller.decide(SECOND).publish
    controller.rest()
    controller.cancel_goal()
    assert not controller.decide(SECOND + 1).publish
    controller.follow(request_of(STRAIGHT), SECOND + 2, same_goal=False)
    assert controller.decide(SECOND + 2).publish
    only_paths = dataclasses.replace(SETTINGS, goal_topics=False)
    assert not controller_of(policy, only_paths, without=['goal_pose']).decide(SECOND).publish


def test_reaching_the_end_is_told_without_a_code_or_a_reason():
    assert (REACHED.code, REACHED.text) == (0, '')
