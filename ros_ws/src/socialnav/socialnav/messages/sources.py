"""Who says a list of agents, where several publishers say one on the same topic."""

import secrets
import struct
from typing import Any

from socialnav.messages.unread import Unread

LONGEST = 200
"""Characters of a source that count."""
STAMP = 8
"""Bytes of a stamp."""


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

    :param data: four bytes of which the second tells the order of bytes, then the message: stamp,
        frame and source, texts with their length in front and aligned to four bytes.
    """
    order = '<' if data[1:2] == b'\x01' else '>'
    try:
        frame = text_at(data, 4 + STAMP, order)[1]
        return text_at(data, frame, order)[0].decode(errors='replace')[:LONGEST]
    except struct.error:
        return ''


def text_at(data: bytes, start: int, order: str) -> tuple[bytes, int]:
    """
    Return a serialized text and where what follows it begins.

    :param start: of its length.
    :param order: of bytes, as struct has it.
    :raises struct.error: the data end before.
    """
    (length,) = struct.unpack_from(f'{order}I', data, start)
    end = start + 4 + length
    if end > len(data):
        raise struct.error('the data end within a text')
    return data[start + 4 : max(end - 1, start + 4)], end + -end % 4
