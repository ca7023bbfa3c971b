"""Laws of the end of a run: the place, then the heading; no middleware is needed for them."""

import dataclasses
import math

from helpers.controllers import controller_of, give, SECOND, SETTINGS
from helpers.worlds import messages_of, random_state
import numpy as np
import pytest

from socialnav.control.arrival import STIFF, turn_rate
from socialnav.control.reasons import Cause
from socialnav_core.simulation.kinematics import Limits

TURNING = dataclasses.replace(
    SETTINGS, goal_yaw_tolerance=0.1, max_turn_rate=1.5, max_angular_acceleration=3.0
)
PERIOD = SETTINGS.period


def at_goal(heading, rate=0.0):
    """Return a robot that stands at its goal, whose heading is 0."""
    state = random_state(0, pedestrians=0, obstacles=0)
    state.robot.goal[:], state.robot.velocity[:] = state.robot.position, 0.0
    state.robot.heading[:], state.robot.turn_rate[:] = heading, rate
    return state


def sent(decision, kinematics):
    """Return speed and turn rate of a decision."""
    if kinematics == 'differential':
        return abs(decision.command[0]), decision.command[1]
    return float(np.hypot(*decision.command)), decision.turn_rate


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
@pytest.mark.parametrize('heading', [3.1, -2.0, 0.15, -0.3])
def test_a_robot_at_its_place_turns_on_the_spot_within_its_limits_until_it_looks_along(
    policy, kinematics, heading
):
    settings = dataclasses.replace(TURNING, kinematics=kinematics)
    controller, rate, rates = controller_of(policy, settings, state=at_goal(heading)), 0.0, []
    for tick in range(60):
        now = SECOND + int(tick * PERIOD * 1e9)
        give(controller, at_goal(heading, rate), now, without=['goal_pose'])
        decision = controller.decide(now)
        if decision.cause is Cause.ARRIVED:
            break
        speed, wanted = sent(decision, kinematics)
        assert speed == 0.0
        assert abs(wanted - rate) <= settings.max_angular_acceleration * PERIOD + 1e-9
        rates.append(wanted)
        heading, rate = heading + wanted * PERIOD, wanted
    assert controller.goal_reached and abs(heading) <= settings.goal_yaw_tolerance
    assert 0.0 < max(map(abs, rates)) <= settings.max_turn_rate
    assert len(set(np.sign(rates))) == 1, 'it has turned too far'


def test_a_robot_that_looks_along_already_has_arrived_at_once(policy):
    controller = controller_of(policy, TURNING, state=at_goal(0.05))
    assert controller.decide(SECOND).cause is Cause.ARRIVED and not policy.states


def test_without_the_parameter_any_heading_will_do(policy):
    assert SETTINGS.goal_yaw_tolerance == math.inf
    controller = controller_of(policy, state=at_goal(3.0))
    assert controller.decide(SECOND).cause is Cause.ARRIVED


def test_a_robot_that_leaves_its_place_while_it_turns_does_not_drive_to_it_again(policy):
    controller = controller_of(policy, TURNING, state=at_goal(2.0))
    controller.decide(SECOND)
    moved = at_goal(2.0)
    moved.robot.position[:] += 1.0
    give(controller, moved, SECOND + 1, without=['goal_pose'])
    decision = controller.decide(SECOND + 1)
    assert decision.turn_rate < 0.0 and not policy.states


def test_a_goal_elsewhere_is_driven_to_though_the_heading_is_wrong(policy):
    state = at_goal(2.0)
    state.robot.goal[:] += 3.0
    controller = controller_of(policy, TURNING, state=state)
    decision = controller.decide(SECOND)
    assert decision.reason is None and decision.turn_rate == 0.0 and policy.states


def test_another_heading_at_the_same_place_is_another_goal(policy):
    controller = controller_of(policy, TURNING, state=at_goal(0.0))
    assert controller.decide(SECOND).cause is Cause.ARRIVED
    goal = messages_of(at_goal(0.0), SECOND)['goal_pose']
    goal.pose.orientation.z, goal.pose.orientation.w = 1.0, 0.0
    controller.store('goal_pose', goal)
    assert abs(controller.decide(SECOND).turn_rate) > 0.0


def test_an_orientation_that_is_none_stops_the_robot_only_where_it_counts(policy):
    goal = messages_of(at_goal(2.0), SECOND)['goal_pose']
    goal.pose.orientation.w = 0.0
    for settings, cause in ((SETTINGS, Cause.ARRIVED), (TURNING, Cause.CONTROL)):
        controller = controller_of(policy, settings, state=at_goal(2.0))
        controller.store('goal_pose', goal)
        assert controller.decide(SECOND).cause is cause


def test_a_robot_that_does_not_turn_is_told_of_until_it_does(policy):
    settings = dataclasses.replace(TURNING, progress_timeout=1.0)
    controller = controller_of(policy, settings, state=at_goal(2.0))
    for tick in range(14):
        now, heading = SECOND + int(tick * PERIOD * 1e9), 2.0 if tick < 12 else 1.9
        give(controller, at_goal(heading), now, without=['goal_pose'])
        decision = controller.decide(now)
        assert (decision.concern == STIFF) == (10 <= tick < 12) and decision.turn_rate


@pytest.mark.parametrize('missing', [-3.0, -0.02, 0.0, 0.4, 3.0])
def test_a_turn_ends_without_a_swing_back_also_at_the_limit_of_braking(missing):
    limits = Limits(1.0, math.inf, 2.0, PERIOD, 1.0)
    left, rate = missing, 0.0
    for _ in range(300):
        rate = turn_rate(left, rate, limits)
        left -= rate * PERIOD
    assert abs(left) < 0.01 and abs(rate) < 0.02
