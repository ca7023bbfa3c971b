"""Messages that are read only when somebody wants to know what they say."""

import dataclasses
from typing import Any

from rclpy._rclpy_pybind11 import RMWError
from rclpy.serialization import deserialize_message


@dataclasses.dataclass(frozen=True)
class Unread:
    """A message as it came; many are replaced by newer ones before they matter."""

    kind: type
    """Type of the message."""
    data: bytes
    """The message, serialized."""


def content(message: Any) -> Any:
    """
    Return a message, read if it was not; None where it cannot be read.

    :param message: Unread, or a message already, or None.
    """
    if not isinstance(message, Unread):
        return message
    try:
        return deserialize_message(message.data, message.kind)
    except RMWError:
        return None
