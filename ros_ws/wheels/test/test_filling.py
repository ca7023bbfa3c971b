"""Laws of messages that are filled with what was typed."""

import time

from geometry_msgs.msg import Point, Polygon, PoseStamped
import pytest
from sensor_msgs.msg import LaserScan
from small_ros2.filling import fill
from small_ros2.messages import message_text
import yaml


def test_whole_numbers_fit_into_real_fields_at_any_depth() -> None:
    message = PoseStamped()
    fill(message, {'header': {'frame_id': 'map'}, 'pose': {'position': {'x': 3}}})
    assert (message.header.frame_id, message.pose.position.x) == ('map', 3.0)
    assert message.pose.orientation.w == 1.0


def test_a_list_of_mappings_becomes_messages() -> None:
    message = Polygon()
    fill(message, {'points': [{'x': 1}, {'y': 2.5}]})
    assert [(point.x, point.y) for point in message.points] == [(1.0, 0.0), (0.0, 2.5)]


def test_a_message_is_filled_with_what_it_is_printed_as() -> None:
    scan, copy = LaserScan(ranges=[0.5, 2.0], range_max=6.0), LaserScan()
    scan.header.frame_id = 'laser'
    fill(copy, yaml.safe_load(message_text(scan, None)))
    assert copy == scan


def test_now_is_the_time_of_a_stamp() -> None:
    message = PoseStamped()
    before = time.time()
    fill(message, {'header': {'stamp': 'now', 'frame_id': 'now'}})
    stamp = message.header.stamp.sec + message.header.stamp.nanosec * 1e-9
    assert before - 1e-6 <= stamp <= time.time() + 1e-6
    assert message.header.frame_id == 'now'


@pytest.mark.parametrize('values', [{'w': 1.0}, {'x': 'far'}, [1.0]])
def test_what_does_not_fit_is_an_error(values: object) -> None:
    with pytest.raises((AssertionError, AttributeError, TypeError)):
        fill(Point(), values)
