"""Frames for tf2 and from it; tf2 has no wheels, so stand-ins speak for it."""

import math
import sys
import types

from geometry_msgs.msg import TransformStamped, Vector3
from helpers.worlds import messages_of, quaternion_of, random_state
import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.messages.transforms import placement_of_transform, Transforms
from socialnav.simulator.transform_publisher import TransformPublisher
from socialnav.simulator.world_messages import Frames
from socialnav_core.sensing import Pose

FRAMES = Frames('map', 'odom', 'base_link')


def transform_of(x, y, heading):
    """Return a transform on the ground."""
    transform = TransformStamped()
    transform.transform.translation = Vector3(x=x, y=y)
    transform.transform.rotation = quaternion_of(heading)
    return transform


class Topics:
    """Stands in for a node; keeps what is published."""

    def __init__(self):
        self.sent = {}

    def create_publisher(self, kind, topic, profile):
        self.sent[topic] = []
        return types.SimpleNamespace(publish=self.sent[topic].append)


def test_the_simulator_tells_where_the_robot_is_and_once_where_the_map_is():
    topics, state = Topics(), random_state(0)
    publisher = TransformPublisher(topics, FRAMES, types.SimpleNamespace, 7)
    for _ in range(2):
        publisher.publish(messages_of(state, 8)['odom'])
    [standing] = topics.sent['/tf_static']
    frames = standing.transforms[0].header.frame_id, standing.transforms[0].child_frame_id
    assert frames == ('map', 'odom')
    assert placement_of_transform(standing.transforms[0]) == Pose()
    moving = topics.sent['/tf'][1].transforms[0]
    assert (moving.header.frame_id, moving.child_frame_id) == ('odom', 'base_link')
    placement = placement_of_transform(moving)
    assert (placement.x, placement.y) == tuple(state.robot.position[0])
    assert placement.heading == pytest.approx(float(state.robot.heading[0]))


def test_a_transform_is_where_the_child_lies_in_the_parent():
    placement = placement_of_transform(transform_of(1.0, 2.0, 0.5))
    assert (placement.x, placement.y, placement.heading) == pytest.approx((1.0, 2.0, 0.5))


def test_a_transform_with_nan_is_refused():
    with pytest.raises(ConversionError, match='translation'):
        placement_of_transform(transform_of(math.nan, 2.0, 0.5))


@pytest.fixture
def tf2(monkeypatch):
    """Put a stand-in for tf2_ros in place; return what it is asked."""
    module, asked = types.ModuleType('tf2_ros'), []
    module.__spec__ = types.SimpleNamespace()

    class TransformException(Exception):
        pass

    class Buffer:
        def lookup_transform(self, frame, source, time, timeout):
            asked.append((frame, source, time.nanoseconds, timeout.nanoseconds))
            if source == 'nowhere':
                raise TransformException('"nowhere" does not exist')
            return transform_of(1.0, 2.0, 0.5)

    class TransformListener:
        def __init__(self, buffer, node, spin_thread):
            self.executor = types.SimpleNamespace(shutdown=lambda: asked.append('shutdown'))
            self.dedicated_listener_thread = types.SimpleNamespace(join=lambda: None)

    module.Buffer, module.TransformListener = Buffer, TransformListener
    module.TransformException = TransformException
    monkeypatch.setitem(sys.modules, 'tf2_ros', module)
    return asked


def test_tf2_is_asked_for_the_moment_and_waited_for_a_tenth_of_a_second(graph, tf2):
    transforms = Transforms(graph.node)
    placement = transforms.locate('odom', 'map', 123)
    assert (placement.x, placement.y, placement.heading) == pytest.approx((1.0, 2.0, 0.5))
    assert tf2 == [('odom', 'map', 123, 100_000_000)]
    transforms.close()
    assert tf2[1:] == ['shutdown']


def test_what_tf2_does_not_know_is_said_in_its_words(graph, tf2):
    transforms = Transforms(graph.node)
    with pytest.raises(LookupError, match='no transform to \'odom\': "nowhere" does not exist'):
        transforms.locate('odom', 'nowhere', 0)
    transforms.close()


def test_without_tf2_it_is_said_that_it_is_missing(graph, monkeypatch):
    monkeypatch.setattr('socialnav.messages.transforms.find_spec', lambda name: None)
    with pytest.raises(LookupError, match="be in 'odom', since tf2_ros is not installed"):
        Transforms(graph.node).locate('odom', 'map', 0)
