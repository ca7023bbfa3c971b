"""Settings from and to mappings and YAML; an unknown key is an error that names the nearest."""

from collections.abc import Collection, Iterable, Mapping
import dataclasses
import difflib
import math
import types
from typing import Any, TypeVar

import yaml

from socialnav_core.config.documents import DEEPEST, parse_yaml
from socialnav_core.config.ranges import (
    ConfigError,
    hints_of,
    OneOf,
    plain_and_rules,
    require_rule,
    shown,
)

Settings = TypeVar('Settings')
LONGEST_ASSIGNMENT = 10_000  # characters


def require(condition: bool, message: str) -> None:
    """Raise a ConfigError unless a condition holds."""
    if not condition:
        raise ConfigError(message)


def require_choice(name: str, value: str, choices: Collection[str]) -> None:
    """Raise a ConfigError unless a value is one of the choices."""
    refusal = OneOf(choices).refusal(value)
    require(refusal is None, f'{name} {refusal}')


def to_mapping(settings: Any) -> dict[str, Any]:
    """Return a dataclass as nested mappings of plain values."""
    return dataclasses.asdict(settings)


def from_mapping(kind: type[Settings], values: Mapping[str, Any], where: str = '') -> Settings:
    """
    Build a dataclass from nested mappings; fields that are not named keep their defaults.

    :param where: dotted path of the mapping, for messages.
    :raises ConfigError: for an unknown key, a missing one or a value that it cannot have.
    """
    if not isinstance(values, Mapping):
        raise ConfigError(
            f'{where or "the configuration"} must be a mapping, not {shown(values)}', where
        )
    hints = hints_of(kind)  # type: ignore[arg-type]  # a class can be hashed
    for key in values:
        if key not in hints:
            raise ConfigError(unknown_key(where, str(key), hints), join(where, str(key)))
    for field in dataclasses.fields(kind):  # type: ignore[arg-type]
        if field.default is dataclasses.MISSING and field.name not in values:
            raise ConfigError(f'{join(where, field.name)} is missing', where)
    converted = {
        key: convert(hints[key], value, join(where, key)) for key, value in values.items()
    }
    return kind(**converted)


def replace(settings: Settings, assignments: Mapping[str, Any], where: str = '') -> Settings:
    """
    Return settings with some fields replaced.

    :param assignments: dotted field names and values, such as {'orca.time_horizon': 4}.
    :param where: dotted path of the settings, for messages.
    :raises ConfigError: for an unknown key or a value of the wrong type.
    """
    values = to_mapping(settings)
    for path, value in assignments.items():
        assign(values, path, value)
    return from_mapping(type(settings), values, where)


def assign(values: dict[str, Any], path: str, value: Any) -> None:
    """
    Set a value at a dotted path in place; sections that are missing are made.

    Whether there is such a setting comes out when the mapping becomes a dataclass.
    """
    *sections, last = path.split('.')
    if len(sections) > DEEPEST:
        raise ConfigError(unknown_key('', path, values))
    for section in sections:
        inner = values.get(section)
        values[section] = dict(inner) if isinstance(inner, Mapping) else {}
        values = values[section]
    values[last] = value


def flatten(values: Mapping[str, Any], where: str = '') -> dict[str, Any]:
    """
    Return nested mappings as one with dotted keys.

    :param where: dotted path that is put before each key.
    """
    flat: dict[str, Any] = {}
    for key, value in values.items():
        if isinstance(value, Mapping):
            flat.update(flatten(value, join(where, str(key))))
        else:
            flat[join(where, str(key))] = value
    return flat


def parse_assignments(texts: Iterable[str]) -> dict[str, Any]:
    """
    Return the keys and values of key=value texts, as typed on the command line.

    :param texts: each a dotted key, an equals sign and a YAML value.
    :raises ConfigError: for a text without a key or an equals sign.
    """
    assignments = {}
    for text in texts:
        key, equals, value = text.partition('=')
        if not key.strip() or not equals:
            raise ConfigError(f'{shown(text)} is not of the form section.key=value')
        if len(text) > LONGEST_ASSIGNMENT:
            raise ConfigError(f'--set {shown(key)}: longer than {LONGEST_ASSIGNMENT} characters')
        assignments[key.strip()] = parse_yaml(value, f'--set {shown(key.strip())}')
    return assignments


def to_yaml(settings: Any) -> str:
    """Return a dataclass as YAML, fields in the order of the dataclass."""
    return yaml.safe_dump(to_mapping(settings), sort_keys=False)


def convert(hint: Any, value: Any, where: str) -> Any:
    """
    Return a value as the type of its field; whole numbers pass for floats and nothing else does.

    :param hint: bool, int, float, str, a dataclass or a pair of floats that may be None, annotated
        by the rule that the value must obey.
    :param where: dotted path of the field, for messages.
    :raises ConfigError: when the types do not fit, or for a value that the rule refuses.
    """
    kind, *rules = plain_and_rules(hint)
    if isinstance(kind, type) and dataclasses.is_dataclass(kind):
        return value if isinstance(value, kind) else from_mapping(kind, value, where)
    if isinstance(kind, types.UnionType):  # a place, or none
        numbers = value if isinstance(value, (list, tuple)) else ()
        value = tuple(as_float(number) for number in numbers) or value
    else:
        value = as_float(value) if kind is float else value
        if type(value) is not kind:
            raise ConfigError(
                f'{where} must be a value of type {kind.__name__}, not {shown(value)}', where
            )
    for rule in rules:
        require_rule(kind, rule, value, where)
    return value


def as_float(value: Any) -> Any:
    """Return a number, or the text of one (YAML 1.1 reads 1e-3 as text), as a float."""
    if isinstance(value, str):
        return number_from_text(value)
    if type(value) is not int:
        return value
    try:
        return float(value)
    except OverflowError:
        return math.inf


def number_from_text(text: str) -> float | str:
    """Return a text as a number where it is one, else as it is."""
    try:
        return float(text)
    except ValueError:
        return text


def unknown_key(where: str, key: str, known: Iterable[str]) -> str:
    """
    Return the message for a key that does not exist.

    :param where: dotted path of the mapping.
    """
    return f'unknown setting {shown(join(where, key))}; {hint(key, known)}'


def hint(key: str, known: Iterable[str]) -> str:
    """Return which of the names that exist may be meant by one that does not."""
    names = list(known)
    nearest = difflib.get_close_matches(key[:100], names, n=1, cutoff=0.5)
    return f'did you mean {nearest[0]}?' if nearest else f'there are: {", ".join(names)}'


def join(where: str, key: str) -> str:
    """
    Return a dotted path.

    :param where: path so far, may be empty.
    """
    return f'{where}.{key}' if where else key
