"""Messages that nobody should send: hostile values in any type, or in a good message."""

from collections.abc import Callable
import copy
import math
import re
from typing import Any

import numpy as np
from rclpy.serialization import serialize_message

FLOATS = (
    math.nan, math.inf, -math.inf, 0.0, -0.0, 1.0, -1.0, 1e-310, 1e9, -1e9, 1e18, 1e38, -1e38,
)  # fmt: skip
DOUBLES = (*FLOATS, 1e154, 1e300, -1.7e308, 1.7e308, 5e-324)
"""A float has no room for those that only a double has."""
TEXTS = (
    '', 'odom', 'map', 'base_link', 'base_footprint', '/odom', 'a' * 300, 'b' * 100_000,
    'Grüße 世界', '\x1b[31mred', 'line\nline', '{}%s', '../../etc', ' ',
)  # fmt: skip
LENGTHS = (0, 1, 2, 3, 17, 300)
LONG = 2500
"""A length that few lists have, now and then."""
SECONDS = (0, 1, -1, -(2**31), 2**31 - 1)


class Hostile:
    """Draws hostile messages; one seed, one sequence."""

    def __init__(self, seed: int, now: Callable[[], int]) -> None:
        """
        Begin a sequence.

        :param now: returns the time that a right stamp would have, ns.
        """
        self.generator = np.random.default_rng(seed)
        self._now = now

    def choice(self, options: Any) -> Any:
        """Return one of some options."""
        return options[self.generator.integers(len(options))]

    def chance(self, probability: float) -> bool:
        """Return whether something happens that has a probability."""
        return bool(self.generator.random() < probability)

    def filled(self, kind: type, depth: int = 0) -> Any:
        """Return a message of a type, all of which is hostile."""
        message = kind()
        for name, declared in kind.get_fields_and_field_types().items():
            setattr(message, name, self.value(declared, getattr(message, name), depth))
        return message

    def changed(self, message: Any, changes: int | None = None) -> Any:
        """
        Return a copy of a message in which some fields are hostile.

        :param changes: how many; None for one to four.
        """
        result = copy.deepcopy(message)
        for _ in range(changes or 1 + self.generator.integers(4)):
            self.change(result)
        return result

    def change(self, message: Any) -> None:
        """Change one field, somewhere."""
        fields = message.get_fields_and_field_types()
        if not fields:
            return
        name = self.choice(list(fields))
        present = getattr(message, name)
        if is_message(present):
            self.change(present)
        elif is_list_of_messages(present) and self.chance(0.7):
            self.change(self.choice(present))
        else:
            setattr(message, name, self.value(fields[name], present, 0))

    def value(self, declared: str, present: Any, depth: int) -> Any:
        """
        Return a value for a field.

        :param declared: its type, as messages name it.
        :param present: what it is now, which tells the Python type of what is nested.
        """
        array = re.fullmatch(r'(.+)\[(\d+)\]', declared)
        listed = re.fullmatch(r'sequence<(.+?)(?:, \d+)?>', declared)
        if array:
            return [self.value(array[1], None, depth) for _ in range(int(array[2]))]
        if listed:
            return self.list_of(listed[1], present, depth)
        if declared == 'builtin_interfaces/Time':
            return self.stamp(type(present))
        if '/' in declared:
            return self.filled(type(present), depth + 1)
        return self.plain(declared)

    def list_of(self, declared: str, present: Any, depth: int) -> list:
        """Return a list of values; of messages only where there is one to go by."""
        length = LONG if self.chance(0.02) else self.choice(LENGTHS)
        if '/' in declared:
            if not is_list_of_messages(present):
                return []
            one = self.changed(self.choice(present), 1)
            return [one if self.chance(0.9) else self.changed(one, 1) for _ in range(length)]
        return [self.plain(declared) for _ in range(length)]

    def stamp(self, kind: type) -> Any:
        """Return a time: the right one, none, long ago, far away, or none that can be."""
        second = 10**9
        now = self._now()
        near = (now, now - second // 5, now - 5 * second, now + 5 * second)
        if self.chance(0.5):
            seconds, rest = divmod(self.choice(near), second)
            return kind(sec=int(seconds), nanosec=int(rest))
        return kind(sec=self.choice(SECONDS), nanosec=self.choice((0, 1, 2**32 - 1)))

    def plain(self, declared: str) -> Any:
        """Return a number, a text or a truth value."""
        if declared in ('double', 'float'):
            if self.chance(0.3):
                return float(np.float32(self.generator.normal(scale=5.0)))
            return self.choice(DOUBLES if declared == 'double' else FLOATS)
        if declared in ('string', 'wstring'):
            return self.choice(TEXTS)
        if declared in ('boolean',):
            return self.chance(0.5)
        if declared == 'octet':
            return bytes([self.generator.integers(256)])
        number = re.fullmatch(r'(u?int)(\d+)', declared)
        size = 2 ** int(number[2])
        low, high = (0, size - 1) if number[1] == 'uint' else (-size // 2, size // 2 - 1)
        return self.choice((low, high, 0, 1, high // 7))

    def bytes_of(self, message: Any) -> bytes:
        """Return a message as bytes of which some are wrong, or missing."""
        data = bytearray(serialize_message(message))
        if self.chance(0.5):
            data = data[: 4 + self.generator.integers(len(data) - 3)]
        for _ in range(self.generator.integers(4)):
            data[self.generator.integers(len(data))] = self.generator.integers(256)
        return bytes(data)


def is_list_of_messages(value: Any) -> bool:
    """Return whether a value is a list with a message in it."""
    return isinstance(value, list) and bool(value) and is_message(value[0])


def is_message(value: Any) -> bool:
    """Return whether a value is a message."""
    return hasattr(value, 'get_fields_and_field_types')
