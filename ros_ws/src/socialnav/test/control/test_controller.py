"""Laws of the decision; no middleware is needed for them."""

import dataclasses
import math

from helpers.controllers import controller_of, give, LOCKSTEP, SECOND, SETTINGS
from helpers.worlds import apart, messages_of, random_state
import numpy as np
import pytest
import torch

from socialnav.control.controller import Controller
from socialnav_core.config import PolicyConfig, ScreeningConfig
from socialnav_core.policies import build_network, ValuePolicy
from socialnav_core.sensing import HERE


def test_fresh_inputs_make_the_robot_drive(policy):
    decision = controller_of(policy).decide(SECOND)
    assert decision.reason is None
    assert np.linalg.norm(decision.command) == pytest.approx(0.5)


@pytest.mark.parametrize('name', ['odom', 'pedestrians', 'goal_pose'])
def test_without_an_input_the_robot_stands_and_says_which(policy, name):
    decision = controller_of(policy, without=[name]).decide(SECOND)
    assert decision.command.tolist() == [0.0, 0.0]
    assert decision.reason == f'no {name}'


def test_without_obstacles_the_robot_stands_unless_it_is_told_that_they_are_not_required(policy):
    assert controller_of(policy, without=['obstacles']).decide(SECOND).reason == 'no obstacles'
    settings = dataclasses.replace(SETTINGS, require_obstacles=False)
    decision = controller_of(policy, settings, without=['obstacles']).decide(SECOND)
    assert decision.reason is None


@pytest.mark.parametrize('name', ['odom', 'pedestrians'])
def test_a_stale_input_gives_zero_velocity(policy, name):
    controller = controller_of(policy)
    fresh = messages_of(random_state(0), 2 * SECOND)
    for other in {'odom', 'pedestrians'} - {name}:
        controller.store(other, fresh[other])
    policy.now += 1.0
    decision = controller.decide(2 * SECOND)
    assert decision.command.tolist() == [0.0, 0.0]
    assert decision.reason == f'{name} older than 0.5 s'


def test_inputs_can_be_acted_on_until_the_oldest_that_ages_is_too_old(policy):
    controller = controller_of(policy)
    controller.store('odom', messages_of(random_state(0), SECOND + SECOND // 5)['odom'])
    assert controller.time_left(SECOND + SECOND // 4) == pytest.approx(0.25)
    assert controller.time_left(2 * SECOND) == pytest.approx(-0.5)
    controller.settings = dataclasses.replace(SETTINGS, obstacles_timeout=0.3)
    assert controller.time_left(SECOND + SECOND // 4) == pytest.approx(0.05)


@pytest.mark.parametrize(('period', 'timeout'), [(0.1, 0.5), (1.0, 0.05), (0.01, 10.0)])
def test_a_stall_is_noticed_after_a_period_and_before_the_robot_must_have_stopped(period, timeout):
    settings = dataclasses.replace(
        SETTINGS, controller_frequency=1 / period, input_timeout=timeout
    )
    assert period < settings.stall_timeout < period + timeout


def test_a_stamp_that_is_old_when_the_message_comes_is_a_matter_of_clocks(policy):
    controller = controller_of(policy)
    for age, text in ((2.0, 'are the clocks in step?'), (2e9, 'use_sim_time')):
        now = SECOND + int(age * 1e9)
        assert controller.decide(now).reason == 'odom older than 0.5 s'  # a clock that jumps
        policy.now += 0.1
        give(controller, random_state(0), SECOND)
        reason = controller.decide(now).reason
        assert controller.decide(SECOND).reason is None
        assert reason.startswith('odom older than 0.5 s by its stamp, though it has just come')
        assert text in reason
    future = controller_of(policy, stamp=10**18).decide(SECOND).reason
    assert 'from the future' in future and 'use_sim_time' in future


def test_a_twist_is_read_in_the_frame_that_odometry_names_or_refused(policy):
    state = random_state(0)
    for child, reason in (('base_link', None), ('', None), ('odom', None), ('foot', 'child')):
        messages = messages_of(state, SECOND)
        messages['odom'].child_frame_id = child
        if child == 'odom':
            velocity = messages['odom'].twist.twist.linear
            velocity.x, velocity.y = state.robot.velocity[0].tolist()
        controller = controller_of(policy, state=state)
        controller.store('odom', messages['odom'])
        decision = controller.decide(SECOND)
        assert (decision.reason is None) == (reason is None), decision.reason
        np.testing.assert_allclose(policy.states[-1].robot.velocity, state.robot.velocity)
    assert "'foot'" in decision.reason and 'base_frame' in decision.reason


def test_an_input_from_the_future_gives_zero_velocity(policy):
    assert 'future' in controller_of(policy, stamp=5 * SECOND).decide(SECOND).reason


def test_obstacles_do_not_age_unless_that_is_wanted(policy):
    controller = controller_of(policy)
    now = messages_of(random_state(0), 9 * SECOND)
    controller.store('odom', now['odom'])
    controller.store('pedestrians', now['pedestrians'])
    assert controller.decide(9 * SECOND).reason is None
    controller.settings = dataclasses.replace(SETTINGS, obstacles_timeout=2.0)
    policy.now += 8.0
    assert controller.decide(9 * SECOND).reason == 'obstacles older than 2 s'


def test_a_position_that_is_not_finite_gives_zero_velocity(policy):
    state = random_state(0)
    state.agents.position[0, 1, 0] = math.nan
    decision = controller_of(policy, state=state).decide(SECOND)
    assert decision.command.tolist() == [0.0, 0.0]
    assert decision.reason.startswith('pedestrians: position')


@pytest.mark.parametrize('turn_rate', [math.nan, math.inf, 1e308])
def test_a_turn_rate_that_cannot_be_gives_zero_velocity(policy, turn_rate):
    controller = controller_of(policy)
    odometry = messages_of(random_state(0), SECOND - SECOND // 20)['odom']
    odometry.twist.twist.angular.z = turn_rate
    controller.store('odom', odometry)
    decision = controller.decide(SECOND)
    assert np.isfinite(decision.command).all()
    if not math.isfinite(turn_rate):
        assert decision.reason == 'odom: turn rate with NaN or infinity'


def test_an_error_anywhere_in_a_decision_gives_zero_velocity(policy):
    def locate(frame, source, stamp):
        raise RuntimeError('no idea')

    controller = Controller(policy, SETTINGS, steady=lambda: policy.now, locate=locate)
    give(controller, random_state(0), SECOND)
    goal = messages_of(random_state(0), SECOND)['goal_pose']
    goal.header.frame_id = 'map'
    controller.store('goal_pose', goal)
    decision = controller.decide(SECOND)
    assert decision.command.tolist() == [0.0, 0.0]
    assert decision.reason == 'the decision failed: RuntimeError: no idea'


def test_a_transform_that_is_waited_for_makes_a_decision_late(policy):
    def locate(frame, source, stamp):
        policy.now += 0.15
        return HERE

    controller = Controller(policy, SETTINGS, steady=lambda: policy.now, locate=locate)
    give(controller, random_state(0), SECOND)
    goal = messages_of(random_state(0), SECOND)['goal_pose']
    goal.header.frame_id = 'map'
    controller.store('goal_pose', goal)
    assert controller.decide(SECOND).reason == 'the decision took 0.15 s, longer than a period'
    assert controller.intention is None and controller.tally.late == 1


def test_a_goal_that_was_typed_counts_again_after_it_was_cancelled_and_a_stamped_one_does_not(
    policy,
):
    for stamp, reason in ((0, None), (SECOND, 'no goal_pose')):
        controller = controller_of(policy)
        goal = messages_of(random_state(0), stamp)['goal_pose']
        controller.store('goal_pose', goal)
        assert controller.cancel_goal()
        controller.store('goal_pose', goal)
        assert controller.decide(SECOND).reason == reason


def test_the_robot_stands_at_its_goal_until_there_is_another(policy):
    state = random_state(0)
    state.robot.goal[:] = state.robot.position + 0.1
    controller = controller_of(policy, state=state)
    assert controller.decide(SECOND).reason == 'goal reached' and controller.goal_reached
    state.robot.goal[:] += 3.0
    give(controller, state, SECOND + 1)
    assert controller.decide(SECOND).reason is None and not controller.goal_reached


def test_a_goal_reached_once_stays_reached(policy):
    state = random_state(0)
    state.robot.goal[:] = state.robot.position + 0.1
    controller = controller_of(policy, state=state)
    controller.decide(SECOND)
    state.robot.position[:] += 1.0
    give(controller, state, SECOND + 1, without=['goal_pose'])
    assert controller.decide(SECOND).reason == 'goal reached'


def test_a_repeated_goal_begins_no_new_run(policy):
    controller = controller_of(policy)
    controller.decide(SECOND)
    give(controller, random_state(0), SECOND)
    controller.decide(SECOND)
    assert policy.resets == 1


def test_another_goal_begins_a_new_run_even_where_it_has_the_stamp_of_the_one_before(policy):
    state = random_state(0)
    state.robot.goal[:] = state.robot.position + 0.1
    controller = controller_of(policy, state=state)
    assert controller.decide(SECOND).reason == 'goal reached'
    state.robot.goal[:] += 3.0
    give(controller, state, SECOND)
    assert controller.decide(SECOND).reason is None and policy.resets == 2


def test_everybody_is_moved_to_the_moment_of_the_command(policy):
    state = random_state(0)
    controller_of(policy).decide(SECOND + SECOND // 5)
    seen = policy.states[0]
    expected = state.robot.position + 0.2 * state.robot.velocity
    np.testing.assert_allclose(seen.robot.position, expected, atol=1e-6)
    np.testing.assert_allclose(
        seen.agents.position, state.agents.position + 0.2 * state.agents.velocity, atol=1e-6
    )


def test_the_time_that_decisions_take_is_looked_ahead(policy):
    state = random_state(0)
    controller = controller_of(policy)
    policy.duration = 0.05
    controller.decide(SECOND)
    controller.decide(SECOND)
    expected = state.robot.position + 0.05 * state.robot.velocity
    np.testing.assert_allclose(policy.states[1].robot.position, expected, atol=1e-6)


def test_a_decision_that_fails_gives_zero_velocity(policy):
    controller = controller_of(policy)
    policy.error = RuntimeError('broken')
    decision = controller.decide(SECOND)
    assert decision.command.tolist() == [0.0, 0.0] and 'broken' in decision.reason


def test_a_decision_that_comes_too_late_gives_zero_velocity(policy):
    controller = controller_of(policy)
    policy.duration = 0.2
    decision = controller.decide(SECOND)
    assert decision.command.tolist() == [0.0, 0.0] and 'longer than a period' in decision.reason


def test_a_velocity_that_is_none_gives_zero_velocity(policy):
    policy.command = [math.nan, 0.0]
    assert controller_of(policy).decide(SECOND).command.tolist() == [0.0, 0.0]


def test_the_command_is_in_the_frame_of_the_robot(policy):
    state = random_state(0)
    state.robot.heading[:] = math.pi / 2
    command = controller_of(policy, state=state).decide(SECOND).command
    np.testing.assert_allclose(command, [0.0, -0.5], atol=1e-12)


def test_no_command_is_faster_than_the_robot(policy):
    policy.command = [3.0, 4.0]
    command = controller_of(policy).decide(SECOND).command
    assert np.linalg.norm(command) == pytest.approx(1.0)


def test_no_command_changes_the_velocity_faster_than_the_robot_can(policy):
    state = random_state(0)
    state.robot.velocity[:], state.robot.heading[:] = 0.0, 0.0
    settings = dataclasses.replace(SETTINGS, max_acceleration=2.0)
    command = controller_of(policy, settings, state=state).decide(SECOND).command
    np.testing.assert_allclose(command, [0.2, 0.0], atol=1e-12)


def test_commands_beyond_the_limits_are_counted_and_others_are_not(policy):
    controller = controller_of(policy)
    controller.decide(SECOND)
    assert controller.tally.clamped == 0
    policy.command = [3.0, 4.0]
    controller.decide(SECOND)
    assert (controller.tally.clamped, controller.tally.decisions) == (1, 2)


def test_a_policy_is_told_the_limits_of_the_moment(policy):
    controller = controller_of(policy)
    controller.decide(SECOND)
    controller.settings = dataclasses.replace(SETTINGS, max_speed=0.2)
    controller.decide(SECOND)
    slower = dataclasses.replace(SETTINGS.limits, speed=0.2)
    assert policy.limits == [SETTINGS.limits, slower]


def test_an_intention_tells_the_plan_of_a_policy_that_has_one(policy):
    controller = controller_of(policy)
    controller.decide(SECOND)
    assert controller.intention.plan is None
    policy.plan = np.ones((1, 4, 2))
    controller.decide(SECOND)
    assert controller.intention.plan.tolist() == np.ones((4, 2)).tolist()


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
def test_a_look_ahead_chooses_within_the_limits_so_that_none_is_clamped(kinematics):
    torch.manual_seed(0)
    config = PolicyConfig(kinematics=kinematics, screening=ScreeningConfig(enabled=True))
    settings = dataclasses.replace(
        SETTINGS, kinematics=kinematics, max_speed=0.7, max_acceleration=1.0, max_turn_rate=1.0
    )
    controller = Controller(
        ValuePolicy(build_network(config), config), settings, steady=lambda: 0.0
    )
    for seed in range(20):
        give(controller, apart(random_state(seed)), SECOND + seed)
        assert controller.decide(SECOND).reason is None
    assert (controller.tally.clamped, controller.tally.decisions) == (0, 20)


def test_a_late_decision_is_counted(policy):
    controller = controller_of(policy)
    policy.duration = 0.2
    controller.decide(SECOND)
    assert controller.tally.late == 1


def test_after_nothing_but_stops_it_goes_silent_until_it_drives_again(policy):
    controller = controller_of(policy)
    assert controller.decide(9 * SECOND).publish
    policy.now = 11.0
    assert not controller.decide(9 * SECOND).publish
    give(controller, random_state(0), 9 * SECOND)
    assert controller.decide(9 * SECOND).publish


def test_only_the_nearest_agents_reach_the_policy(policy):
    settings = dataclasses.replace(SETTINGS, max_agents=2)
    controller_of(policy, settings).decide(SECOND)
    assert policy.states[0].agents.count == 2


def test_in_lockstep_a_state_is_complete_when_all_four_have_one_stamp(policy):
    controller = controller_of(policy, LOCKSTEP, without=['goal_pose'])
    assert not controller.take_complete_state()
    messages = messages_of(random_state(0), 2 * SECOND)
    controller.store('goal_pose', messages['goal_pose'])
    assert not controller.take_complete_state()
    give(controller, random_state(0), 2 * SECOND)
    assert controller.take_complete_state()


def test_in_lockstep_a_state_is_taken_once(policy):
    controller = controller_of(policy, LOCKSTEP)
    assert controller.take_complete_state() and not controller.take_complete_state()


def test_in_lockstep_a_repeated_state_gets_the_same_answer_without_a_decision(policy):
    controller = controller_of(policy, LOCKSTEP)
    first = controller.decide(0)
    give(controller, random_state(0), SECOND)
    assert controller.decide(0) is first and len(policy.states) == 1


def test_in_lockstep_nothing_ages_and_nothing_is_extrapolated(policy):
    controller_of(policy, LOCKSTEP).decide(99 * SECOND)
    np.testing.assert_array_equal(
        policy.states[0].agents.position, random_state(0).agents.position
    )


def test_in_lockstep_a_break_of_the_clock_begins_a_new_run(policy):
    controller = controller_of(policy, LOCKSTEP)
    controller.decide(0)
    give(controller, random_state(0), SECOND + SECOND // 4)
    controller.decide(0)
    assert policy.resets == 1 and policy.states[1].time[0] == 0.25
    give(controller, random_state(0), 3 * SECOND)
    controller.decide(0)
    assert policy.resets == 2 and policy.states[2].time[0] == 0.0


def test_in_lockstep_a_failing_policy_is_not_hidden(policy):
    policy.error = RuntimeError('broken')
    with pytest.raises(RuntimeError, match='broken'):
        controller_of(policy, LOCKSTEP).decide(0)
