"""Laws of ROS messages that are filled from mappings."""

import math

from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from helpers.worlds import random_state
from nav_msgs.msg import Odometry, Path
import numpy as np
import pytest
from rclpy.serialization import deserialize_message, serialize_message
from visualization_msgs.msg import Marker, MarkerArray

from socialnav.messages.filling import filled
from socialnav_core import messages
from socialnav_msgs.msg import AgentStates, EpisodeResult

STATE, COMMAND, STAMP = random_state(0), np.array([0.3, -0.4]), 7 * 10**9 + 5
END = messages.EpisodeEnd('hard', 1, 2, 'collision_pedestrian', 3.5, 4.5, math.inf, 14)
TWISTS = [messages.twist(COMMAND, kinematics) for kinematics in ('holonomic', 'differential')]
CONTENTS = [
    (AgentStates, messages.agent_states(STATE, False, STAMP, 'odom')),
    (AgentStates, messages.agent_states(STATE, True, STAMP, 'odom')),
    (Odometry, messages.odometry(STATE, STAMP, 'odom', 'base_link')),
    (PoseStamped, messages.goal(STATE, STAMP, 'odom')),
    *((Twist, twist) for twist in TWISTS),
    (TwistStamped, messages.stamped_twist(TWISTS[0], STAMP, 'base_link')),
    (MarkerArray, messages.world_markers(STATE, 0.3, STAMP, 'odom')),
    (MarkerArray, messages.attention_markers(STATE, np.full(5, 0.2), STAMP, 'odom')),
    (Path, messages.predicted_path(STATE, COMMAND, 'holonomic', STAMP, 'odom')),
    (EpisodeResult, messages.episode_result(END, STAMP, 'odom')),
]


def assert_holds(message, content):
    """Check that a message, or a part of one, is what a mapping says."""
    if isinstance(content, dict):
        for name, value in content.items():
            assert_holds(getattr(message, name), value)
    elif isinstance(content, list):
        for one, value in zip(message, content, strict=True):
            assert_holds(one, value)
    else:
        expected = pytest.approx(content, rel=1e-6) if isinstance(content, float) else content
        assert message == expected


@pytest.mark.parametrize(('kind', 'content'), CONTENTS)
def test_what_the_core_says_arrives_over_the_wire(kind, content):
    sent = serialize_message(filled(kind, content))
    assert_holds(deserialize_message(sent, kind), content)


def test_fields_that_are_not_named_keep_their_defaults():
    marker = filled(Marker, {'id': 3, 'pose': {'position': {'x': 1.0}}})
    assert (marker.id, marker.pose.position.x) == (3, 1.0)
    assert marker.pose.orientation.w == 1.0 and marker.scale == Marker().scale


def test_messages_share_nothing_that_one_of_them_may_change():
    content = messages.world_markers(STATE, 0.3, STAMP, 'odom')
    one, other = (filled(MarkerArray, content).markers for _ in range(2))
    one[1].header.frame_id, one[1].color.r = 'map', 0.0
    assert other[1].header.frame_id == one[2].header.frame_id == 'odom'
    assert other[1].color.r == content['markers'][1]['color']['r']


@pytest.mark.parametrize('content', [{'speed': 1.0}, {'linear': {'w': 1.0}}])
def test_a_field_that_a_type_does_not_have_is_refused(content):
    with pytest.raises(AttributeError):
        filled(Twist, content)
