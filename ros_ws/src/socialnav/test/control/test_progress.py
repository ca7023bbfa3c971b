"""Laws of the check of progress; no middleware is needed for them."""

import dataclasses

from helpers.controllers import controller_of, give, LOCKSTEP, SECOND, SETTINGS
from helpers.plans import plan_of, read
from helpers.worlds import messages_of, random_state
import numpy as np
import pytest

from socialnav.control.progress import ASTRAY, HELD, ProgressCheck, STANDS
from socialnav.control.reasons import GIVEN_UP

QUICK = dataclasses.replace(
    SETTINGS, progress_distance=0.5, progress_timeout=1.0, progress_stop_timeout=3.0
)


GOAL = np.array([9.0, 0.0])


def watch(check, decisions, speed=1.0, gain=0.0, place=0.0, goal=GOAL, plan=None, left=None):
    """Let a robot decide; it comes nearer by so much each time, m; return where it is, m."""
    for _ in range(decisions):
        check.look(np.array([place, 0.0]), np.array(goal), plan, left, QUICK)
        check.choose(speed, QUICK)
        place, left = place + gain, None if left is None else left - gain
    return place


@pytest.mark.parametrize(('speed', 'cause'), [(1.0, HELD), (0.0, STANDS)])
def test_what_is_wrong_is_said_after_the_first_limit_and_the_second_one_stops(speed, cause):
    check = ProgressCheck()
    watch(check, 9, speed)
    assert check.complaint is None
    watch(check, 1, speed)
    assert cause in check.complaint and not check.stopped
    watch(check, 20, speed)
    assert cause in check.complaint and check.stopped and check.complaint.endswith(GIVEN_UP)


def test_a_robot_that_moves_but_not_nearer_has_no_progress():
    check = ProgressCheck()
    watch(check, 31, gain=-0.1)
    assert ASTRAY in check.complaint and check.stopped


def test_coming_nearer_by_the_distance_ends_what_was_said():
    check = ProgressCheck()
    watch(check, 15)
    assert check.complaint
    watch(check, 2, gain=0.6)
    assert check.complaint is None and check.idle < 0.3


def test_a_robot_that_comes_nearer_slowly_but_soon_enough_never_complains():
    check, place = ProgressCheck(), 0.0
    for _ in range(140):
        place = watch(check, 1, gain=0.06, place=place)
        assert check.complaint is None


def test_another_plan_is_no_progress_however_short_it_is():
    check = ProgressCheck()
    for number in range(31):
        watch(check, 1, plan=number % 3 or None, left=9.0 - 2.0 * (number % 2))
    assert check.stopped


def test_a_longer_plan_takes_nothing_from_what_was_gained():
    check, place = ProgressCheck(), 0.0
    for number in range(60):
        left = 30.0 - 0.1 * number + 5.0 * (number // 10)
        place = watch(check, 1, gain=0.1, place=place, plan=number // 10, left=left)
        assert check.complaint is None


@pytest.mark.parametrize(('gain', 'complains'), [(0.1, False), (0.0, True)])
def test_a_robot_that_follows_a_goal_that_moves_has_progress_where_it_moves(gain, complains):
    check, place = ProgressCheck(), 0.0
    for number in range(30):
        goal = [9.0 + 0.1 * number, 0.0]
        check.aim(np.array(goal), 0.1 * number, QUICK)
        place = watch(check, 1, gain=gain, place=place, goal=goal)
        assert complains or check.complaint is None
    assert check.stopped == complains


def test_a_goal_that_is_said_again_and_again_gives_no_time_and_one_after_a_pause_does():
    check = ProgressCheck()
    for number in range(40):
        check.aim(GOAL, 0.1 * number, QUICK)
        watch(check, 1)
    assert check.stopped
    check.aim(GOAL, 4.0, QUICK)
    assert check.stopped
    check.aim(GOAL, 20.0, QUICK)
    assert not check.stopped and check.complaint is None


def test_a_goal_elsewhere_ends_a_stop_at_once():
    check = ProgressCheck()
    check.aim(GOAL, 0.0, QUICK)
    watch(check, 40)
    check.aim(GOAL + (0.1, 0.0), 4.0, QUICK)
    assert check.stopped
    check.aim(GOAL + (0.6, 0.0), 4.1, QUICK)
    assert not check.stopped


def test_a_robot_that_was_stopped_goes_on_where_the_way_was_closed_and_is_free():
    check = ProgressCheck()
    watch(check, 40, speed=0.0)
    assert check.stopped
    watch(check, 60, speed=0.0)
    watch(check, 1)
    assert not check.stopped and check.complaint is None


def test_a_robot_that_is_held_stays_stopped_also_where_the_policy_stands_for_a_moment():
    check = ProgressCheck()
    watch(check, 40)
    for _ in range(5):
        watch(check, 20, speed=0.0)
        watch(check, 20)
    assert check.stopped


def test_time_counts_only_where_the_robot_drives(policy):
    controller = controller_of(policy, QUICK)
    for _ in range(9):
        assert controller.decide(SECOND).concern is None
    policy.now += 100.0
    for _ in range(100):
        assert 'older' in controller.decide(9 * SECOND).reason
    assert controller.progress.idle == pytest.approx(0.9)


def test_a_controller_says_that_stops_and_goes_on_with_another_goal(policy):
    state = random_state(0)
    controller = controller_of(policy, QUICK, state=state)
    decisions = [controller.decide(SECOND) for _ in range(31)]
    assert [one.concern is not None for one in decisions[:29]] == [False] * 9 + [True] * 20
    assert HELD in decisions[15].concern and decisions[15].command.any()
    assert decisions[30].reason.endswith(GIVEN_UP) and not decisions[30].command.any()
    assert controller.intention is None
    state.robot.goal[:] += 1.0
    give(controller, state, SECOND + 1)
    assert controller.decide(SECOND).reason is None


def test_a_cancelled_goal_and_a_limit_that_is_lifted_end_a_stop_too(policy):
    controller = controller_of(policy, QUICK)
    for end in (controller.cancel_goal, lambda: setattr(controller, 'settings', SETTINGS)):
        controller.settings = QUICK
        give(controller, random_state(0), SECOND)
        for _ in range(40):
            decision = controller.decide(SECOND)
        assert decision.reason.endswith(GIVEN_UP)
        end()
        give(controller, random_state(0), SECOND)
        controller.store('goal_pose', messages_of(random_state(0), 0)['goal_pose'])
        assert controller.decide(SECOND).reason is None


def test_along_a_plan_the_way_counts_and_not_the_distance_to_the_goal(policy):
    state = random_state(0)
    controller = controller_of(policy, QUICK, state=state)
    start, goal = state.robot.position[0].copy(), state.robot.goal[0]
    away = start + (start - goal) / np.linalg.norm(goal - start) * 9.0
    side = away + (3.0, -3.0)
    controller.store('plan', read(plan_of([tuple(start), tuple(away), tuple(side), tuple(goal)])))
    for number in range(60):
        state.robot.position[:] = start + (away - start) * number / 100
        give(controller, state, SECOND, without=['goal_pose'])
        decision = controller.decide(SECOND)
        assert decision.reason is None and decision.concern is None


def test_in_lockstep_nothing_is_said_of_progress(policy):
    settings = dataclasses.replace(LOCKSTEP, progress_timeout=0.5, progress_stop_timeout=0.5)
    controller = controller_of(policy, settings)
    for number in range(20):
        give(controller, random_state(0), SECOND + number * SECOND // 4)
        decision = controller.decide(0)
        assert decision.reason is None and decision.concern is None


@pytest.mark.parametrize('name', ['progress_timeout', 'progress_stop_timeout'])
def test_a_limit_of_0_is_none(policy, name):
    controller = controller_of(policy, dataclasses.replace(QUICK, **{name: 0.0}))
    decisions = [controller.decide(SECOND) for _ in range(60)]
    assert all((one.reason is None) == (name == 'progress_stop_timeout') for one in decisions[31:])
    assert (decisions[20].concern is None) == (name == 'progress_timeout')
