"""Laws of messages of sensors."""

import math

from geometry_msgs.msg import PoseArray
from helpers.worlds import messages_of, random_state
import numpy as np
import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.messages.detection_types import DETECTION_TYPES
from socialnav.messages.sensor_messages import (
    detection_points,
    detections_message,
    discs_message,
    scan_message,
    scan_points,
    tracks_message,
)
from socialnav.messages.stamps import header_message, nanoseconds_of
from socialnav.perception.locating import Locator
from socialnav_core.sensing import beam_angles, Tracks

SECOND = 10**9
POSITIONS = np.array([[1.0, 2.0], [-0.5, 0.25]])


@pytest.fixture
def locator():
    """Return a locator that knows where a robot was at second 1."""
    result = Locator('odom', 'base_link', 0.2)
    result.store(messages_of(random_state(0), SECOND)['odom'])
    return result


def detected(message, locator):
    """Return where somebody was seen, in the frame of odom."""
    source = 'poses' if isinstance(message, PoseArray) else 'agents'
    return detection_points(message, DETECTION_TYPES[source], locator.frame)


def test_a_scan_is_read_as_it_was_written():
    ranges = np.array([1.0, 2.0, np.inf, 4.0])
    points, _ = scan_points(scan_message(ranges, 10.0, 0.05, SECOND, 'base_link'))
    angles = beam_angles(4)[[0, 1, 3]]
    expected = ranges[[0, 1, 3], None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    np.testing.assert_allclose(points, expected, atol=1e-6)


def test_a_scan_tells_its_time_frame_and_limits():
    message = scan_message(np.ones(8), 10.0, 0.05, SECOND, 'laser')
    assert nanoseconds_of(message.header.stamp) == SECOND
    assert (message.header.frame_id, message.range_max) == ('laser', 10.0)
    last = message.angle_min + 7 * message.angle_increment
    assert last == pytest.approx(message.angle_max)


def test_a_scan_without_a_measurement_is_refused_with_the_reason():
    with pytest.raises(ConversionError, match='scan: 0 of 8 beams measured anything'):
        scan_points(scan_message(np.full(8, np.nan), 10.0, 0.05, SECOND, 'laser'))


def test_detections_are_read_as_they_were_written(locator):
    message = detections_message(POSITIONS, SECOND, 'odom')
    np.testing.assert_array_equal(detected(message, locator), POSITIONS)


def test_agents_without_velocities_are_detections_too(locator):
    state = random_state(1)
    message = messages_of(state, SECOND)['pedestrians']
    for agent in message.agents:
        agent.velocity.x = math.nan
    expected = state.agents.position[0][~state.agents.static[0]]
    np.testing.assert_array_equal(detected(message, locator), expected)


def test_detections_in_the_frame_of_the_robot_are_where_the_robot_saw_them(locator):
    message = detections_message(POSITIONS, SECOND, 'base_link')
    expected = locator.base(SECOND).placed(POSITIONS)
    np.testing.assert_allclose(detected(message, locator), expected)


@pytest.mark.parametrize(
    ('message', 'reason'),
    [
        (detections_message(POSITIONS, SECOND, 'camera'), "in frame 'camera'"),
        (detections_message(POSITIONS, 3 * SECOND, 'base_link'), 'no odom within 0.2 s'),
        (detections_message(np.full((1, 2), np.nan), SECOND, 'odom'), 'position with NaN'),
    ],
)
def test_detections_that_cannot_be_used_are_refused_with_the_reason(locator, message, reason):
    with pytest.raises(ConversionError, match=reason):
        detected(message, locator)


def test_nobody_detected_is_no_position(locator):
    empty = PoseArray(header=header_message(SECOND, 'odom'))
    assert detected(empty, locator).shape == (0, 2)


def test_tracks_become_pedestrians_with_their_names_and_velocities():
    known = np.ones(2, dtype=bool)
    tracks = Tracks(np.array([7, 2**32 + 1]), POSITIONS, -POSITIONS, known)
    agents = tracks_message(tracks, 0.3, SECOND, 'odom').agents
    assert [agent.id for agent in agents] == [7, 1]
    assert (agents[0].position.y, agents[0].velocity.y, agents[0].radius) == (2.0, -2.0, 0.3)


def test_discs_become_obstacles_that_stand():
    agents = discs_message(POSITIONS, np.array([0.4, 0.1]), 0, 'odom').agents
    assert (agents[1].position.x, agents[1].velocity.x, agents[1].radius) == (-0.5, 0.0, 0.1)
    assert [agent.id for agent in agents] == [0, 1]
