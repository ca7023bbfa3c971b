"""What most messages are made of."""

import math
from typing import Any

import numpy as np

Message = dict[str, Any]
"""Values by the names of a message's fields; a field that is not named keeps its default."""


def time(nanoseconds: int) -> Message:
    """Return a builtin_interfaces/Time."""
    return {'sec': nanoseconds // 10**9, 'nanosec': nanoseconds % 10**9}


def header(nanoseconds: int, frame: str) -> Message:
    """Return a std_msgs/Header."""
    return {'stamp': time(nanoseconds), 'frame_id': frame}


def vector(plane: np.ndarray, z: float = 0.0) -> Message:
    """Return a geometry_msgs/Point or Vector3 of x and y, (2,), and z."""
    x, y = plane.tolist()
    return {'x': x, 'y': y, 'z': z}


def rotation(heading: float) -> Message:
    """Return the rotation by a heading, rad, about the z axis as a geometry_msgs/Quaternion."""
    return {'x': 0.0, 'y': 0.0, 'z': math.sin(heading / 2), 'w': math.cos(heading / 2)}
