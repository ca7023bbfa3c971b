"""Settings from and to mappings and YAML; an unknown key is an error that names the nearest."""

from collections.abc import Collection, Iterable, Mapping
import dataclasses
import difflib
from pathlib import Path
import typing
from typing import Any, TypeVar

import yaml

Settings = TypeVar('Settings')


class ConfigError(ValueError):
    """A setting that does not exist or cannot have the value given."""


def require(condition: bool, message: str) -> None:
    """Raise a ConfigError unless a condition holds."""
    if not condition:
        raise ConfigError(message)


def require_choice(name: str, value: str, choices: Collection[str]) -> None:
    """Raise a ConfigError unless a value is one of the choices."""
    require(value in choices, f'{name} must be one of {", ".join(choices)}, not {value!r}')


def to_mapping(settings: Any) -> dict[str, Any]:
    """Return a dataclass as nested mappings of plain values."""
    return dataclasses.asdict(settings)


def from_mapping(kind: type[Settings], values: Mapping[str, Any], where: str = '') -> Settings:
    """
    Build a dataclass from nested mappings; fields that are not named keep their defaults.

    :param where: dotted path of the mapping, for messages.
    :raises ConfigError: for an unknown key, a missing one or a value of the wrong type.
    """
    if not isinstance(values, Mapping):
        raise ConfigError(f'{where or "the configuration"} must be a mapping, not {values!r}')
    types = typing.get_type_hints(kind)
    for key in values:
        if key not in types:
            raise ConfigError(unknown_key(where, str(key), types))
    converted = {
        key: convert(types[key], value, join(where, key)) for key, value in values.items()
    }
    try:
        return kind(**converted)
    except TypeError as error:
        raise ConfigError(f'{where or "the configuration"}: {error}') from error


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
        if not key or not equals:
            raise ConfigError(f'{text!r} is not of the form section.key=value')
        assignments[key.strip()] = yaml.safe_load(value)
    return assignments


def read_yaml(path: Path) -> dict[str, Any]:
    """
    Return the mapping that a YAML file holds.

    :raises ConfigError: when it cannot be read or holds no mapping.
    """
    try:
        values = yaml.safe_load(path.read_text(encoding='utf-8'))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise ConfigError(f'{path} cannot be read: {" ".join(str(error).split())}') from error
    if not isinstance(values, dict):
        raise ConfigError(f'{path} must hold a mapping of settings')
    return values


def to_yaml(settings: Any) -> str:
    """Return a dataclass as YAML, fields in the order of the dataclass."""
    return yaml.safe_dump(to_mapping(settings), sort_keys=False)


def convert(kind: Any, value: Any, where: str) -> Any:
    """
    Return a value as the type of its field; whole numbers pass for floats and nothing else does.

    :param kind: bool, int, float, str or a dataclass.
    :param where: dotted path of the field, for messages.
    :raises ConfigError: when the types do not fit.
    """
    if isinstance(kind, type) and dataclasses.is_dataclass(kind):
        return value if isinstance(value, kind) else from_mapping(kind, value, where)
    if kind is float and isinstance(value, str):  # YAML 1.1 reads 1e-3 as text
        value = number_from_text(value)
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if type(value) is not kind:
        raise ConfigError(f'{where} must be a value of type {kind.__name__}, not {value!r}')
    return value


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
    return f'unknown setting {join(where, key)!r}; {hint(key, known)}'


def hint(key: str, known: Iterable[str]) -> str:
    """Return which of the names that exist may be meant by one that does not."""
    names = list(known)
    nearest = difflib.get_close_matches(key, names, n=1, cutoff=0.5)
    return f'did you mean {nearest[0]}?' if nearest else f'there are: {", ".join(names)}'


def join(where: str, key: str) -> str:
    """
    Return a dotted path.

    :param where: path so far, may be empty.
    """
    return f'{where}.{key}' if where else key
