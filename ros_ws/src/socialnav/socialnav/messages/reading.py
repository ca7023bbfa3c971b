"""Messages from the bytes in which they came."""

from typing import Any

from rclpy.serialization import deserialize_message


def message_in(kind: type, data: bytes) -> Any:
    """Return a message of a type; None where the bytes are none."""
    try:
        return deserialize_message(data, kind)
    except RuntimeError:  # of which rclpy's RMWError is one, whose own name is private
        return None
