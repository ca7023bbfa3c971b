"""
Requests to follow a path, read in the memory of the middleware.

rclpy makes five objects of each pose, which takes tens of milliseconds for a long path, in which
nothing else runs, and a navigation stack sends one every second. Here the places are copied as
one array.
The layout of messages in memory is that of rosidl's generator for C.
"""

import ctypes
import dataclasses
import types
from typing import Any

from geometry_msgs.msg import PoseStamped, Quaternion
import numpy as np
from unique_identifier_msgs.msg import UUID

from socialnav.messages.filling import filled
from socialnav.messages.paths import MIXED, ReadPath
from socialnav.messages.stamps import header_message

FIELDS = {
    'path': 'nav_msgs/Path',
    'controller_id': 'string',
    'goal_checker_id': 'string',
    'progress_checker_id': 'string',
}
"""How the goal of FollowPath begins; what may come after them is not read."""


class Text(ctypes.Structure):
    """A string."""

    _fields_ = [
        ('data', ctypes.c_void_p), ('size', ctypes.c_size_t), ('capacity', ctypes.c_size_t)
    ]  # fmt: skip


class Header(ctypes.Structure):
    """A std_msgs/Header."""

    _fields_ = [('seconds', ctypes.c_int32), ('nanoseconds', ctypes.c_uint32), ('frame', Text)]


class Sequence(ctypes.Structure):
    """Any unbounded sequence."""

    _fields_ = Text._fields_


class SendGoal(ctypes.Structure):
    """A request to the service that begins a FollowPath."""

    _fields_ = [
        ('goal_id', ctypes.c_uint8 * 16),
        ('header', Header),
        ('poses', Sequence),
        ('controller_id', Text),
        ('goal_checker_id', Text),
        ('progress_checker_id', Text),
    ]


POSE = np.dtype(
    [
        ('stamp', 'u8'), ('frame', [('data', 'u8'), ('size', 'u8'), ('capacity', 'u8')]),
        ('position', 'f8', 3), ('orientation', 'f8', 4),
    ]
)  # fmt: skip
"""A geometry_msgs/PoseStamped."""


@dataclasses.dataclass(frozen=True)
class FollowRequest:
    """A path that somebody wants to be followed, and how."""

    path: ReadPath
    """The path."""
    end: PoseStamped
    """Its last pose, in the frame and with the time of the path."""
    controller_id: str = ''
    goal_checker_id: str = ''
    progress_checker_id: str = ''


def readable(fields: dict[str, str]) -> bool:
    """Return whether a goal with such fields is laid out as it is read here."""
    return list(fields.items())[: len(FIELDS)] == list(FIELDS.items())


def request_at(address: int) -> Any:
    """Return what rclpy makes of a request in memory: its goal_id, and the FollowRequest."""
    message = SendGoal.from_address(address)
    goal_id = UUID(uuid=np.array(message.goal_id, dtype=np.uint8))
    return types.SimpleNamespace(goal_id=goal_id, goal=request_of(message))


def request_of(message: SendGoal) -> FollowRequest:
    """Return a request whose arrays are its own."""
    stamp = message.header.seconds * 10**9 + message.header.nanoseconds
    header = header_message(stamp, text_of(message.header.frame))
    poses = poses_of(message.poses)
    frames = frames_of(poses)
    path = ReadPath(header, poses['position'][:, :2], frames.pop() if len(frames) == 1 else MIXED)
    end = PoseStamped(header=header)
    if len(poses):
        names = ('x', 'y', 'z', 'w')
        x, y, z = poses['position'][-1].tolist()
        end.pose.position.x, end.pose.position.y, end.pose.position.z = x, y, z
        rotation = dict(zip(names, poses['orientation'][-1].tolist(), strict=True))
        end.pose.orientation = filled(Quaternion, rotation)
    ids = (message.controller_id, message.goal_checker_id, message.progress_checker_id)
    return FollowRequest(path, end, *map(text_of, ids))


def poses_of(sequence: Sequence) -> np.ndarray:
    """Return a copy of poses, with the fields of POSE, (poses,); their frames are not copied."""
    data = ctypes.string_at(sequence.data, sequence.size * POSE.itemsize) if sequence.size else b''
    return np.frombuffer(data, POSE)


def frames_of(poses: np.ndarray) -> set[str]:
    """Return the frames that poses name, while the message is there; one empty name for none."""
    texts = zip(poses['frame']['data'].tolist(), poses['frame']['size'].tolist(), strict=True)
    names = {ctypes.string_at(*text) for text in texts}
    return {name.decode(errors='replace') for name in names} or {''}


def text_of(text: Text) -> str:
    """Return a string."""
    return ctypes.string_at(text.data, text.size).decode(errors='replace') if text.size else ''
