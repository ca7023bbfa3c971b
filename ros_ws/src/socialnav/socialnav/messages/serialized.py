"""The bytes of a serialized message (CDR): its order of bytes, texts and alignment."""

import struct

ENCAPSULATION = 4
"""Bytes before the message, which tell its order of bytes; alignment counts from behind them."""
ORDERS = {0: '>', 1: '<'}
"""What struct calls the order that the second byte tells."""
STAMP = 8
"""Bytes of a time."""


def text_at(body: memoryview | bytes, offset: int, order: str) -> tuple[bytes, int]:
    """
    Return a text and where it ends; its length comes first and counts a zero at its end.

    :param body: the bytes behind the encapsulation.
    :param order: of bytes, as struct names it.
    :raises struct.error: the bytes end before.
    """
    (length,) = struct.unpack_from(order + 'I', body, offset)
    end = offset + 4 + length
    if not 1 <= length <= len(body) - offset - 4:
        raise struct.error('a text longer than the message')
    return bytes(body[offset + 4 : end - 1]), end


def aligned(offset: int, size: int) -> int:
    """Return the next multiple of a size."""
    return -(-offset // size) * size
