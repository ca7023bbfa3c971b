"""Messages from the bytes in which they came."""

from typing import Any

from rclpy.serialization import deserialize_message

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
