"""Who says a list of agents, where several publishers say one on the same topic."""

import secrets
import struct
from typing import Any

from socialnav.messages.serialized import aligned, ENCAPSULATION, ORDERS, STAMP, text_at
from socialnav.messages.unread import Unread

LONGEST = 200
"""Characters of a source that count."""


def new_source(node: str) -> str:
    """
    Return what a process says of itself in its lists; the next one to run says something else.

    :param node: full name of the node.
    """
    return f'{node}:{secrets.token_hex(4)}'


def node_of(source: str) -> str:
    """Return the full name of the node in a source; empty where the source is."""
    return source.partition(':')[0]


def source_of(message: Any) -> str:
    """Return who says a list, which may be unread; empty where it does not tell."""
    if isinstance(message, Unread):
        return serialized_source(message.data)
    return getattr(message, 'source', '')[:LONGEST]


def serialized_source(data: bytes) -> str:
    """
    Return who says a list that is serialized; empty where it does not tell or is no list.

    Reading the whole list costs a hundred times as much, and most lists are replaced unread.

    :param data: the message with its encapsulation.
    """
    try:
        body, order = memoryview(data)[ENCAPSULATION:], ORDERS[data[1]]
        frame_end = text_at(body, STAMP, order)[1]
        source = text_at(body, aligned(frame_end, 4), order)[0]
    except (struct.error, IndexError, KeyError):
        return ''
    return source.decode(errors='replace')[:LONGEST]
