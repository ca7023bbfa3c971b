"""Between messages of sensors and arrays: pure functions that refuse what cannot be true."""

import array
from collections.abc import Callable
from typing import Any

from geometry_msgs.msg import Point, PoseArray, Quaternion
from geometry_msgs.msg import Pose as PoseMessage
import numpy as np
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header

from socialnav.messages.conversions import ConversionError, finite
from socialnav.messages.detection_types import DetectionType
from socialnav.messages.filling import filled
from socialnav.messages.stamps import header_message
from socialnav_core.messages import agent_states_of, header
from socialnav_core.sensing import Geometry, Pose, Readings, scan_beams, Tracks
from socialnav_msgs.msg import AgentStates

Located = Callable[[Header], Pose]
"""Returns the pose of a header's frame at its time; raises a ConversionError where unknown."""


REP_117 = Readings()
"""What ranges that are no distance mean where the driver keeps to REP-117."""
MOST_DETECTIONS = 300
"""Number of people in one message above which it is no crowd but an error."""


def scan_message(
    ranges: np.ndarray, range_max: float, duration: float, nanoseconds: int, frame: str
) -> LaserScan:
    """
    Return a scan that goes all around, from straight behind counter-clockwise.

    :param ranges: m, inf where it is free, (beams,).
    :param range_max: longest range, m.
    :param duration: time between two scans, s.
    """
    increment = 2 * np.pi / len(ranges)
    return LaserScan(
        header=header_message(nanoseconds, frame),
        angle_min=-np.pi,
        angle_max=np.pi - increment,
        angle_increment=increment,
        scan_time=duration,
        range_max=range_max,
        ranges=array.array('f', ranges.astype(np.float32).tobytes()),
    )


def scan_points(
    message: LaserScan, readings: Readings = REP_117, reach: float = np.inf
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return where a scan hit something, m, (returns, 2), and where all beams end, m, (beams, 2).

    Both are in the frame of the laser.

    :param readings: what the driver means by ranges that are no distance.
    :param reach: free beams end here at the latest, m.
    :raises ConversionError: a scan that measured hardly anything or cannot be.
    """
    geometry = Geometry(
        message.angle_min, message.angle_max, message.angle_increment, message.range_min,
        message.range_max,
    )  # fmt: skip
    try:
        return scan_beams(message.ranges, geometry, readings, reach)
    except ValueError as error:
        raise ConversionError(f'scan: {error}') from error


def detections_message(positions: np.ndarray, nanoseconds: int, frame: str) -> PoseArray:
    """
    Return where somebody was seen; the orientations mean nothing.

    :param positions: m, (detections, 2).
    """
    upright = Quaternion(w=1.0)
    poses = [
        PoseMessage(position=Point(x=x, y=y), orientation=upright) for x, y in positions.tolist()
    ]
    return PoseArray(header=header_message(nanoseconds, frame), poses=poses)


def detection_points(message: Any, kind: DetectionType, locate: Located) -> np.ndarray:
    """
    Return where somebody was seen, m, (detections, 2); all else in the message is ignored.

    :raises ConversionError: a position that cannot be, a frame that is unknown, or a crowd that
        no detector sees.
    """
    places = [(place.x, place.y) for place in kind.places(message)]
    if len(places) > MOST_DETECTIONS:
        raise ConversionError(f'detections: {len(places)} people, more than {MOST_DETECTIONS}')
    points = finite('detections', 'position', places)
    return locate(message.header).placed(points.reshape(-1, 2))


def tracks_message(tracks: Tracks, radius: float, nanoseconds: int, frame: str) -> AgentStates:
    """
    Return who is there.

    :param radius: of everybody, m.
    """
    radii = np.full(len(tracks.id), radius)
    content = agent_states_of(
        header(nanoseconds, frame), tracks.id % 2**32, tracks.position, tracks.velocity, radii
    )
    return filled(AgentStates, content)


def discs_message(
    centres: np.ndarray, radii: np.ndarray, nanoseconds: int, frame: str
) -> AgentStates:
    """
    Return what stands; the id of a disc is its place, and tells nothing later.

    :param centres: m, (discs, 2).
    :param radii: m, (discs,).
    """
    ids, still = np.arange(len(radii)), np.zeros_like(centres)
    content = agent_states_of(header(nanoseconds, frame), ids, centres, still, radii)
    return filled(AgentStates, content)
