"""How a field of a dataclass becomes a parameter: what it may be, and when it may change."""

from collections.abc import Iterable
import dataclasses
import math
from typing import Any, ClassVar, Literal, Protocol, TypeVar

Value = TypeVar('Value', bool, int, float, str)
Live = Literal['yes', 'inactive', 'no']


class Parameters(Protocol):
    """A frozen dataclass, each of whose fields was made by parameter()."""

    __dataclass_fields__: ClassVar[dict[str, dataclasses.Field[Any]]]


Settings = TypeVar('Settings', bound=Parameters)


@dataclasses.dataclass(frozen=True)
class Entry:
    """What is known of one parameter."""

    name: str
    """Its name."""
    default: Any
    """Its default, which fixes its type."""
    description: str
    """What it does."""
    unit: str
    """Unit, if it has one."""
    range: tuple[float, float] | None
    """Smallest and largest value."""
    choices: tuple[str, ...]
    """All values of a text that has only few."""
    live: Live
    """Whether it can be changed while the node runs, only while it is inactive, or not at all."""


def parameter(
    default: Value,
    description: str,
    unit: str = '',
    range: tuple[float, float] | None = None,
    *,
    choices: Iterable[str] = (),
    live: Live = 'no',
) -> Value:
    """
    Return a field that is a parameter.

    :param choices: all values of a text that has only few.
    """
    metadata = {
        'description': description, 'unit': unit, 'range': range, 'choices': tuple(choices),
        'live': live,
    }  # fmt: skip
    return dataclasses.field(default=default, metadata=metadata)


def entries(kind: type[Parameters] | Parameters) -> tuple[Entry, ...]:
    """Return what is known of each parameter of a node, in their order."""
    return tuple(
        Entry(field.name, field.default, **field.metadata) for field in dataclasses.fields(kind)
    )


def same_but_live(one: Settings, other: Settings) -> bool:
    """Return whether settings agree in all that cannot change while a node drives."""
    fixed = [entry.name for entry in entries(one) if entry.live != 'yes']
    return all(getattr(one, name) == getattr(other, name) for name in fixed)


def requirement(entry: Entry) -> str:
    """Return what a value must be, in words."""
    if entry.choices:
        return f'must be one of {", ".join(entry.choices)}'
    kind = {bool: 'true or false', int: 'a whole number', str: 'a text'}.get(
        type(entry.default), 'a number with a decimal point'
    )
    if entry.range is None:
        return f'must be {kind}'
    low, high = entry.range
    return f'must be {kind} in [{low:g}, {high:g}]{" " + entry.unit if entry.unit else ""}'


def complaint(entry: Entry, value: Any) -> str | None:
    """Return what is wrong with a value of the right type, or None."""
    low, high = entry.range or (-math.inf, math.inf)
    if entry.choices and value not in entry.choices:
        return f'{entry.name} {requirement(entry)}, not {value!r}'
    if entry.range and not low <= value <= high:
        return f'{entry.name} {requirement(entry)}, not {value!r}'
    return None
