"""Which values a setting may have: said once, beside its type, and checked whenever it is set."""

from collections.abc import Collection
import dataclasses
import functools
import math
import numbers
import re
import reprlib
import typing
from typing import Any

SHOWN_CHARACTERS = 80


class ConfigError(ValueError):
    """A setting that does not exist or cannot have the value given."""

    def __init__(self, message: str, key: str = '') -> None:
        """
        Keep what is wrong.

        :param key: dotted path of the setting, where it is one.
        """
        super().__init__(message)
        self.key = key


@dataclasses.dataclass(frozen=True)
class Range:
    """A number between two others, both allowed."""

    low: float
    high: float
    or_infinite: bool = False
    """Whether .inf is allowed too, which then stands for no limit."""

    def refusal(self, value: Any) -> str | None:
        """Return why a value is refused; None where it is not."""
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            return f'must be a number, not {shown(value)}'
        number: Any = value
        if self.low <= number <= self.high or (self.or_infinite and number == math.inf):
            return None
        return f'must lie in {self}, not {shown(value)}'

    def __str__(self) -> str:
        """Return the range as texts tell it."""
        return f'[{plain(self.low)}, {plain(self.high)}]{" or be .inf" * self.or_infinite}'


@dataclasses.dataclass(frozen=True)
class OneOf:
    """One of some words."""

    choices: Collection[str]

    def refusal(self, value: Any) -> str | None:
        """Return why a value is refused; None where it is not."""
        if isinstance(value, str) and value in self.choices:
            return None
        return f'must be one of {", ".join(self.choices)}, not {shown(value)}'

    def __str__(self) -> str:
        """Return the choices as texts tell them."""
        return ', '.join(self.choices)


@dataclasses.dataclass(frozen=True)
class Pattern:
    """A text of a kind."""

    expression: str
    """Regular expression that all of it matches."""
    meaning: str
    """What that is, in words."""

    def refusal(self, value: Any) -> str | None:
        """Return why a value is refused; None where it is not."""
        if isinstance(value, str) and re.fullmatch(self.expression, value):
            return None
        return f'must be {self}, not {shown(value)}'

    def __str__(self) -> str:
        """Return what the text is, as texts tell it."""
        return self.meaning


NAME = Pattern(
    r'(?=.*\w)[\w.+ -]{1,100}', 'a name of at most 100 letters, digits, spaces and ._+-'
)
"""Of what may be called like a folder."""
DIGEST = Pattern('([0-9a-f]{64})?', 'a SHA-256 in hexadecimal, or nothing')


@dataclasses.dataclass(frozen=True)
class Point:
    """A place in the plane, or none."""

    limit: float
    """Largest coordinate, m."""

    def refusal(self, value: Any) -> str | None:
        """Return why a value is refused; None where it is not."""
        if value is None:
            return None
        if not isinstance(value, tuple) or len(value) != 2:
            return f'must be two numbers [x, y], not {shown(value)}'
        within = Range(-self.limit, self.limit)
        return next(filter(None, map(within.refusal, value)), None)

    def __str__(self) -> str:
        """Return what a place is, as texts tell it."""
        return f'[x, y], each in {Range(-self.limit, self.limit)}, or null'


RULES = (Range, OneOf, Pattern, Point)


@functools.cache
def hints_of(kind: Any) -> dict[str, Any]:
    """Return the types of the fields of a dataclass, with what they are annotated by."""
    return typing.get_type_hints(kind, include_extras=True)


@functools.cache
def rules_of(kind: Any) -> dict[str, tuple[Any, Any]]:
    """Return the type and the rule of each field of a dataclass that has one."""
    rules = {}
    for name, hint in hints_of(kind).items():  # type: ignore[arg-type]
        kind_of, *found = plain_and_rules(hint)
        if found:
            rules[name] = (kind_of, found[0])
    return rules


def plain_and_rules(hint: Any) -> tuple[Any, ...]:
    """Return a type without annotations, followed by the rules that it is annotated by."""
    if typing.get_origin(hint) is not typing.Annotated:
        return (hint,)
    kind, *extras = typing.get_args(hint)
    return (kind, *(extra for extra in extras if isinstance(extra, RULES)))


def require_allowed(settings: Any) -> None:
    """Raise a ConfigError unless every field of a dataclass has a value that it may have."""
    for name, (kind, rule) in rules_of(type(settings)).items():  # type: ignore[arg-type]
        require_rule(kind, rule, getattr(settings, name), name)


def require_rule(kind: Any, rule: Any, value: Any, where: str) -> None:
    """
    Raise a ConfigError unless a value obeys a rule.

    :param kind: type of the setting.
    :param where: dotted path of the setting.
    """
    refusal = rule.refusal(value)
    if refusal is None and kind is int and not isinstance(value, numbers.Integral):
        refusal = f'must be a whole number, not {shown(value)}'
    if refusal is not None:
        raise ConfigError(f'{where} {refusal}', where)


def plain(number: float) -> str:
    """Return a number as people write it: 1,000,000 and not 1e+06."""
    return f'{number:,}' if isinstance(number, int) else f'{number:g}'


def shown(value: Any) -> str:
    """Return a value as messages show it: on one line, cut where it is long."""
    if isinstance(value, int) and not isinstance(value, bool) and abs(value) >= 10**20:
        return 'a number of more than 20 digits'  # Python refuses to print very long ones
    short = reprlib.Repr()
    short.maxstring = short.maxother = SHOWN_CHARACTERS
    return short.repr(value)
