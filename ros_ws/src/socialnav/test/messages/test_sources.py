"""Laws of who says a list."""

from functools import partial

import numpy as np
import pytest
from rclpy.serialization import serialize_message

from socialnav.messages.reading import message_in
from socialnav.messages.sources import LONGEST, new_source, node_of, source_of
from socialnav.messages.stamps import header_message
from socialnav.messages.unread import Unread
from socialnav_msgs.msg import AgentState, AgentStates


def unread(data):
    return Unread(partial(message_in, AgentStates), data)


@pytest.mark.parametrize('frame', ['', 'o', 'odom', 'a_frame', 'ä'])
@pytest.mark.parametrize('source', ['', '/a:1', '/robot/front_obstacles:5f3a21b4', 'ä'])
def test_the_source_of_a_list_is_the_same_whether_it_was_read_or_not(frame, source):
    message = AgentStates(header=header_message(7, frame), source=source, agents=[AgentState()])
    assert source_of(unread(serialize_message(message))) == source_of(message) == source


def test_bytes_that_are_no_list_have_no_source_and_break_nothing():
    generator = np.random.default_rng(0)
    good = serialize_message(AgentStates(header=header_message(7, 'odom'), source='/a:1'))
    for size in range(len(good)):
        assert isinstance(source_of(unread(good[:size])), str)
    for size in range(100):
        assert isinstance(source_of(unread(generator.bytes(size))), str)


def test_a_very_long_source_is_cut():
    message = AgentStates(source='x' * 10**6)
    assert len(source_of(message)) == len(source_of(unread(serialize_message(message)))) == LONGEST


def test_two_processes_of_one_node_have_different_sources_of_one_node():
    one, other = new_source('/ns/node'), new_source('/ns/node')
    assert one != other
    assert node_of(one) == node_of(other) == '/ns/node'
