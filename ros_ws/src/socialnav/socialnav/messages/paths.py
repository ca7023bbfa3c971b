"""
Paths from the bytes in which they came.

rclpy makes five objects of each pose, which takes four seconds for a hundred thousand of them;
here the places are a view of the bytes (CDR, of either order of bytes).
"""

import dataclasses
import struct

import numpy as np
from std_msgs.msg import Header

from socialnav.messages.stamps import header_message

ENCAPSULATION = 4
"""Bytes before the message, which tell its order of bytes."""
ORDERS = {0: '>', 1: '<'}
STAMP = 8
"""Bytes of a time."""
POSE = 56
"""Bytes of a pose without its header: seven doubles."""
MIXED = 'poses in different frames, or cut off'


@dataclasses.dataclass(frozen=True)
class ReadPath:
    """What a path says."""

    header: Header
    """Time and frame."""
    points: np.ndarray
    """Where the poses are, m, (poses, 2)."""
    frame: str
    """Frame that all poses name; MIXED where they differ."""


def read_path(data: bytes) -> ReadPath | None:
    """Return what a serialized path says; None where the bytes are none."""
    try:
        return path_in(memoryview(data)[ENCAPSULATION:], ORDERS[data[1]])
    except (struct.error, IndexError, KeyError, TypeError, ValueError):
        return None


def path_in(body: memoryview, order: str) -> ReadPath:
    """
    Return what a path says; errors of many kinds where the bytes are none.

    :param body: the bytes without the encapsulation, from which alignment counts.
    :param order: of bytes, as struct names it.
    """
    seconds, nanoseconds = struct.unpack_from(order + 'iI', body, 0)
    frame, end = text_at(body, STAMP, order)
    (count,) = struct.unpack_from(order + 'I', body, aligned(end, 4))
    header = header_message(seconds * 10**9 + nanoseconds, frame)
    if count == 0:
        return ReadPath(header, np.zeros((0, 2)), '')
    return ReadPath(header, *poses_at(body, aligned(end, 4) + 4, count, order))


def poses_at(body: memoryview, offset: int, count: int, order: str) -> tuple[np.ndarray, str]:
    """
    Return where poses are, m, (count, 2), and the frame that they name.

    All but the first one begin at a multiple of 8 bytes, and are equally long where they name one
    frame.
    """
    if count * POSE > len(body):
        raise ValueError('more poses than the message has room for')
    frame, end = text_at(body, offset + STAMP, order)
    start, named = aligned(end, 8) + POSE, body[offset + STAMP : end]
    points = np.empty((count, 2))
    points[0] = struct.unpack_from(order + '2d', body, start - POSE)
    if count == 1:
        return points, frame
    place = aligned(STAMP + len(named), 8)
    if start + (count - 1) * (place + POSE) > len(body):
        return np.zeros((0, 2)), MIXED
    rows: np.ndarray = np.ndarray((count - 1, place + POSE), np.uint8, body, start)
    if (rows[:, STAMP : STAMP + len(named)] != np.frombuffer(named, np.uint8)).any():
        return np.zeros((0, 2)), MIXED
    numbers: np.ndarray = np.ndarray(
        (count - 1, 2), order + 'f8', body, start + place, (place + POSE, 8)
    )
    points[1:] = numbers
    return points, frame


def text_at(body: memoryview, offset: int, order: str) -> tuple[str, int]:
    """Return a text, and where it ends; its length comes first and counts a zero at its end."""
    (length,) = struct.unpack_from(order + 'I', body, offset)
    end = offset + 4 + length
    if not 1 <= length <= len(body) - offset - 4:
        raise ValueError('a text longer than the message')
    return bytes(body[offset + 4 : end - 1]).decode(), end


def aligned(offset: int, size: int) -> int:
    """Return the next multiple of a size."""
    return -(-offset // size) * size
