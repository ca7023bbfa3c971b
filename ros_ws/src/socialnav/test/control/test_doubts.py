"""Laws of inputs that look well one by one and cannot be true together."""

import math

from geometry_msgs.msg import PoseStamped
from helpers.controllers import controller_of, give, LOCKSTEP, Recorder, SECOND, SETTINGS
from helpers.worlds import messages_of, random_state
import numpy as np
import pytest

from socialnav.control.doubts import Doubts
from socialnav.control.leaps import believed
from socialnav.control.odometry_check import FROZEN, SILENT, UNFIT
from socialnav.messages.stamps import header_message
from socialnav_core.simulation.kinematics.angles import rotated
from socialnav_msgs.msg import AgentState, AgentStates

PERIOD = 0.1
NORTH = math.pi / 2


def odometry(time, place, heading=NORTH, twist=(0.0, 0.0), rate=0.0, frame='base_link'):
    """Return odometry of a moment, s."""
    state = random_state(0)
    state.robot.position[:], state.robot.heading[:] = [place], heading
    message = messages_of(state, int(time * SECOND))['odom']
    message.child_frame_id = frame
    message.twist.twist.linear.x, message.twist.twist.linear.y = map(float, twist)
    message.twist.twist.angular.z = float(rate)
    return message


def goal(x=5.0, stamp=SECOND):
    """Return a goal."""
    message = PoseStamped(header=header_message(stamp, 'odom'))
    message.pose.position.x = x
    return message


def driven(twist, frame='base_link', way=(0.0, 0.8), heading=NORTH, steps=30, noise=0.0):
    """Return what is doubted of a robot that drives by a velocity of way, and tells a twist."""
    doubts, target = Doubts(), goal()
    generator = np.random.default_rng(0)
    for number in range(steps):
        place = np.array(way) * number * PERIOD + noise * generator.standard_normal(2)
        message = odometry(1 + number * PERIOD, place, heading, twist, frame=frame)
        assert doubts.reason(message, target, SETTINGS) is None
    return doubts.concerns(10.0 + steps * PERIOD)


@pytest.mark.parametrize('noise', [0.0, 0.01])
@pytest.mark.parametrize(
    ('twist', 'frame', 'words'),
    [
        ((0.8, 0.0), 'base_link', None),
        ((0.65, 0.1), 'base_link', None),  # wheels slip
        ((0.0, 0.8), 'odom', None),
        ((0.0, 0.8), 'base_link', 'its twist is in the frame of the pose'),
        ((0.8, 0.0), 'odom', 'its twist is in the frame of the robot'),
        ((0.0, 0.0), 'base_link', SILENT),
        ((-0.8, 0.0), 'base_link', UNFIT),
        ((0.2, 0.0), 'base_link', UNFIT),
    ],
)
def test_a_twist_that_does_not_fit_the_pose_is_named_with_its_cause(twist, frame, words, noise):
    found = driven(twist, frame, noise=noise)
    assert found == [] if words is None else words in found[0]


def test_a_pose_that_stands_while_the_twist_moves_is_named():
    assert FROZEN in driven((0.8, 0.0), way=(0.0, 0.0))[0]


def test_a_robot_that_stands_has_no_doubts_whatever_its_noise():
    assert driven((0.02, -0.01), way=(0.0, 0.0), steps=600, noise=0.004) == []


def test_a_robot_that_turns_while_it_drives_has_no_doubts():
    doubts, target, rate = Doubts(), goal(), 1.5
    place, heading = np.zeros(2), 0.0
    for number in range(60):
        message = odometry(1 + number * PERIOD, place, heading, (0.8, 0.0), rate)
        assert doubts.reason(message, target, SETTINGS) is None
        for _ in range(10):
            place = place + rotated(np.array([0.8, 0.0]), heading) * PERIOD / 10
            heading += rate * PERIOD / 10
    assert doubts.concerns(20.0) == []


def test_a_fault_that_ends_is_not_told_any_more():
    doubts, target = Doubts(), goal()
    for number in range(60):
        twist = (0.0, 0.8) if number < 30 else (0.8, 0.0)
        message = odometry(1 + number * PERIOD, (0.0, 0.08 * number), NORTH, twist)
        doubts.reason(message, target, SETTINGS)
        if number == 29:
            assert doubts.concerns(10.0)
    assert doubts.concerns(10.0) == []


@pytest.mark.parametrize(
    ('place', 'heading', 'later', 'words'),
    [
        ((0.0, 2.0), NORTH, 0.1, 'odom jumped by 2.0 m'),
        ((0.0, 0.0), NORTH + 2.5, 0.1, 'odom turned by 143 degrees'),
        ((0.0, 0.5), NORTH, 0.1, None),
        ((0.0, 2.0), NORTH, 2.0, None),  # it may have driven there
        ((0.0, 9.0), NORTH, 2.0, 'odom jumped by 9.0 m'),
    ],
)
def test_a_robot_that_is_where_it_cannot_be_stands_until_it_has_another_goal(
    place, heading, later, words
):
    doubts, target = Doubts(), goal()
    for time in (1.0, 2.0, 3.0):
        assert doubts.reason(odometry(time, (0.0, 0.0)), target, SETTINGS) is None
    for number in range(3):
        message = odometry(3.0 + later + number * PERIOD, place, heading)
        found = doubts.reason(message, target, SETTINGS)
        assert found is None if words is None else words in found
    assert doubts.reason(message, goal(stamp=2 * SECOND), SETTINGS) is None


def test_a_goal_that_is_only_repeated_is_no_other():
    doubts = Doubts()
    for time, x in ((1.0, 0.0), (3.0, 0.0), (3.1, 3.0), (3.2, 3.0)):
        found = doubts.reason(odometry(time, (x, 0.0)), goal(), SETTINGS)
        assert (found is None) == (x == 0.0)


def test_a_goal_that_is_told_anew_all_the_time_excuses_no_jump():
    doubts = Doubts()
    for number in range(30):
        target = goal(5.0 + 0.01 * number, SECOND + number)
        assert doubts.reason(odometry(1 + 0.1 * number, (0.0, 0.0)), target, SETTINGS) is None
    assert 'jumped' in doubts.reason(odometry(4.0, (3.0, 0.0)), target, SETTINGS)


def test_a_jump_beside_a_goal_elsewhere_is_a_new_beginning():
    doubts = Doubts()
    for time, x, target in ((1.0, 0.0, 5.0), (3.0, 0.0, 7.0), (3.1, 3.0, 7.0)):
        assert doubts.reason(odometry(time, (x, 0.0)), goal(target), SETTINGS) is None


def people(time, *places, velocity=0.0, ids=(1, 2, 3)):
    """Return a list of people."""
    message = AgentStates(header=header_message(int(time * SECOND), 'odom'))
    for number, (x, y) in zip(ids, places, strict=False):
        agent = AgentState(id=number, radius=0.3)
        agent.position.x, agent.position.y, agent.velocity.x = x, y, velocity
        message.agents.append(agent)
    return message


def test_people_who_jump_are_named_for_a_while():
    doubts = Doubts()
    doubts.look_at_people([people(1.0, (0.0, 0.0), (4.0, 0.0))], 10.0)
    doubts.look_at_people([people(1.1, (0.1, 0.0), (0.0, 0.0))], 10.1)
    (words,) = doubts.concerns(10.2)
    assert 'pedestrian 2 jumped by 4.0 m within 0.10 s' in words
    assert doubts.concerns(14.0) == []


@pytest.mark.parametrize('ids', [(7, 7, 7), (1, 2, 3)])
def test_people_who_walk_or_share_an_id_are_no_jump(ids):
    doubts = Doubts()
    for number in range(10):
        places = (0.2 * number, 0.0), (5.0, 0.0)
        doubts.look_at_people([people(1 + 0.1 * number, *places, ids=ids)], 10.0)
    assert doubts.concerns(10.1) == []


def test_who_is_faster_than_anybody_runs_is_named_and_taken_to_stand():
    doubts = Doubts()
    doubts.look_at_people([people(1.0, (3.0, 0.0), velocity=20.0)], 10.0)
    assert 'a pedestrian at 20 m/s, taken to stand' in doubts.concerns(10.1)[0]
    state = random_state(0)
    state.agents.velocity[0, 0] = [0.0, -20.0]
    found = believed(state).agents.velocity
    assert not found[0, 0].any() and (found[0, 1:] == state.agents.velocity[0, 1:]).all()


@pytest.mark.parametrize('settings', [SETTINGS, LOCKSTEP], ids=['real time', 'lockstep'])
def test_a_controller_stands_after_a_jump_but_in_lockstep_where_worlds_change(settings):
    policy = Recorder()
    controller, state = controller_of(policy, settings), random_state(0)
    without = ['goal_pose'] if settings is SETTINGS else []
    for time in (SECOND, 3 * SECOND):
        give(controller, state, time, without if time > SECOND else [])
        assert controller.decide(time).reason is None
    state = state.with_robot(position=state.robot.position + [[0.0, 3.0]])
    later = 3 * SECOND + SECOND // 10
    give(controller, state, later, without)
    reason = controller.decide(later).reason
    assert reason is None if settings is LOCKSTEP else 'odom jumped by' in reason
