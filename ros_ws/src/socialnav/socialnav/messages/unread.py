"""Messages that are read only when somebody wants to know what they say."""

from collections.abc import Callable
import dataclasses
from typing import Any


@dataclasses.dataclass(frozen=True)
class Unread:
    """A message as it came; many are replaced by newer ones before they matter."""

    read: Callable[[bytes], Any]
    """Returns what the message says, or None where it cannot be read."""
    data: bytes
    """The message, serialized."""


def content(message: Any) -> Any:
    """Return a message, read if it was not; None where it cannot be read."""
    return message.read(message.data) if isinstance(message, Unread) else message
