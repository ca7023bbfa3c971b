"""Laws of messages that are read only when they matter."""

from functools import partial

from helpers.controllers import controller_of, Recorder, SECOND
from helpers.driving import Drive
from helpers.worlds import messages_of, random_state
from nav_msgs.msg import Odometry
import pytest
from rclpy.serialization import serialize_message

from socialnav.messages.reading import message_in
from socialnav.messages.unread import content, Unread

BROKEN = Unread(partial(message_in, Odometry), b'no message at all')


def test_reading_gives_the_message_that_was_serialized_and_nothing_where_that_is_impossible():
    message = messages_of(random_state(0))['odom']
    assert content(Unread(partial(message_in, Odometry), serialize_message(message))) == message
    assert content(message) is message
    assert content(BROKEN) is None


def test_inputs_are_not_read_before_there_is_a_goal():
    controller = controller_of(Recorder(), without=['goal_pose'])
    controller.store('odom', BROKEN)
    assert controller.decide(SECOND).reason == 'no goal_pose'
    controller.store('goal_pose', messages_of(random_state(0), SECOND)['goal_pose'])
    assert controller.decide(SECOND).reason == 'odom: a message that cannot be read'
    assert 'odom' not in controller.input_ages(SECOND)
    assert controller.time_left(SECOND) < 0.0


@pytest.mark.parametrize('name', ['odom', 'pedestrians'])
def test_an_input_that_was_not_read_counts_like_one_that_was(name):
    policy, other = Recorder(), Recorder()
    message = messages_of(random_state(0), SECOND)[name]
    controller = controller_of(policy)
    controller.store(name, Unread(partial(message_in, type(message)), serialize_message(message)))
    decision, expected = controller.decide(SECOND), controller_of(other).decide(SECOND)
    assert decision.reason is expected.reason is None
    assert decision.command.tolist() == expected.command.tolist()
    assert policy.states[0].agents.position.tolist() == other.states[0].agents.position.tolist()


def test_bytes_that_are_no_message_stop_the_robot_and_the_next_message_lets_it_go_on(graph):
    drive, state = Drive(graph).start(), random_state(0)
    drive.moves(state)
    odometry = drive.robot.publishers['odom']
    drive.robot.publishers['odom'] = graph.node.create_publisher(Odometry, 'unused', 1)

    def told():
        odometry.publish(b'\x00\x01\x00\x00 no odometry')
        drive.robot.publish(state)
        graph.spin(0.05)
        return drive.health[-1].status[0].message == 'odom: a message that cannot be read'

    graph.wait(told, 'word of the message')
    drive.robot.publishers['odom'] = odometry
    drive.moves(state)
