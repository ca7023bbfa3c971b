"""Messages from the bytes in which they came."""

from collections.abc import Callable
from functools import partial
from typing import Any

from nav_msgs.msg import Odometry, Path
from rclpy.serialization import deserialize_message

from socialnav.messages.paths import read_path
from socialnav_msgs.msg import AgentStates

LONGEST = 256 * 1024
"""Bytes of a message that are read, 4,000 agents: more would keep everything else waiting."""


def message_in(kind: type, data: bytes) -> Any:
    """Return a message of a type; None where the bytes are none, or too many."""
    if len(data) > LONGEST:
        return None
    try:
        return deserialize_message(data, kind)
    except RuntimeError:  # of which rclpy's RMWError is one, whose own name is private
        return None


READERS: dict[type, Callable[[bytes], Any]] = {
    Odometry: partial(message_in, Odometry),
    AgentStates: partial(message_in, AgentStates),
    Path: read_path,
}
"""How messages are read that are kept as bytes until somebody wants them."""
