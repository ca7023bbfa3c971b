"""Laws of paths that are read from bytes."""

import itertools
import time

from geometry_msgs.msg import PoseStamped
from helpers.plans import plan_of, read
from nav_msgs.msg import Path
import numpy as np
import pytest
from rclpy.serialization import serialize_message

from socialnav.messages.paths import MIXED, read_path
from socialnav.messages.stamps import header_message

FRAMES = ('', 'a', 'odom', 'odo/x', 'longer_than_8_bytes')


def path_of(count, frame, outer='odom'):
    """Return a path with numbers of its own in each field."""
    path = Path(header=header_message(7_000_000_003, outer))
    for number in range(count):
        pose = PoseStamped(header=header_message(number * 10**9, frame))
        pose.pose.position.x, pose.pose.position.y = number + 0.5, -3.0 * number
        path.poses.append(pose)
    return path


@pytest.mark.parametrize(('frame', 'outer'), itertools.product(FRAMES, FRAMES))
def test_what_is_read_is_what_was_written(frame, outer):
    for count in (0, 1, 2, 3, 50):
        path = path_of(count, frame, outer)
        data = serialize_message(path)
        result = read_path(data)
        places = [(one.pose.position.x, one.pose.position.y) for one in path.poses]
        np.testing.assert_array_equal(result.points, np.array(places).reshape(-1, 2))
        assert result.header == path.header
        assert result.frame == (frame if count else '')


def test_bytes_in_the_other_order_say_the_same():
    header = np.array([7, 3, 5], '>u4').tobytes() + b'odom\0' + bytes(3)
    pose = np.array([1], '>u4').tobytes() + np.array([1, 2, 1], '>u4').tobytes() + bytes(4)
    numbers = np.array([1.5, -2.5, 0, 0, 0, 0, 1], '>f8').tobytes()
    body = header + pose
    body += bytes(-len(body) % 8) + numbers
    data = b'\0\0\0\0' + body
    result = read_path(data)
    assert result.points.tolist() == [[1.5, -2.5]] and result.header.frame_id == 'odom'
    assert result.header == header_message(7_000_000_003, 'odom')


@pytest.mark.parametrize('number', [0, 1, 7, 49])
@pytest.mark.parametrize('frame', ['map', 'a', '', 'longer_than_8_bytes'])
def test_a_pose_in_a_frame_of_its_own_is_seen(number, frame):
    path = path_of(50, 'odom')
    path.poses[number].header.frame_id = frame
    assert read(path).frame == MIXED


def test_bytes_that_are_cut_or_wrong_are_refused_or_read_and_nothing_else_happens():
    data = serialize_message(path_of(30, 'odom'))
    generator = np.random.default_rng(0)
    for length in range(0, len(data), 5):
        result = read_path(data[:length])
        assert result is None or result.frame == MIXED
    for _ in range(2000):
        wrong = bytearray(data)
        for place in generator.integers(len(data), size=3):
            wrong[place] = generator.integers(256)
        result = read_path(bytes(wrong))
        assert result is None or result.points.shape[1] == 2


def test_a_hundred_thousand_poses_are_read_within_a_decision():
    path = plan_of([(0.0, 0.0)])
    path.poses *= 100_000
    data = serialize_message(path)
    began = time.perf_counter()
    assert read_path(data).points.shape == (100_000, 2)
    assert time.perf_counter() - began < 0.1
