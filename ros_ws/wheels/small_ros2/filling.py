"""Plain values, as YAML gives them, into the fields of a message."""

from collections.abc import Mapping
import re
import time
from typing import Any

import yaml

from small_ros2.command import CommandError
from small_ros2.messages import message_class

NOW = 'now'
"""Stands for the time of a message."""


def filled(kind: type, text: str) -> Any:
    """
    Return a message with the values that were typed.

    :param text: YAML of a mapping from field to value.
    :raises CommandError: when the values do not fit.
    """
    message = kind()
    try:
        fill(message, yaml.safe_load(text) or {})
    except (AssertionError, AttributeError, TypeError, ValueError, yaml.YAMLError) as error:
        raise CommandError(f'Failed to populate field: {error}') from error
    return message


def fill(message: Any, values: Mapping[str, Any]) -> None:
    """
    Set fields of a message; the others keep their defaults.

    :param values: by field; mappings for messages within, lists for arrays.
    :raises AttributeError: there is no such field.
    :raises AssertionError: a value does not fit into its field.
    :raises TypeError: something else than a mapping stands for a message.
    """
    if not isinstance(values, Mapping):
        raise TypeError(f'{type(message).__name__} needs a mapping, not {values!r}')
    kinds = message.get_fields_and_field_types()
    checked = type(message)(check_fields=True)  # others take any value, and fail when it is sent
    for field, value in values.items():
        fitted = fitting(value, getattr(message, field), kinds[field])
        setattr(checked, field, fitted)
        setattr(message, field, fitted)


def fitting(value: Any, present: Any, kind: str) -> Any:
    """
    Return a value in the form that a field wants.

    :param value: as YAML gives it.
    :param present: what is in the field.
    :param kind: type of the field, for instance double or sequence<geometry_msgs/Point>.
    """
    if '/' not in kind:
        return plain(value, present, kind)
    if value == NOW and kind == 'builtin_interfaces/Time':
        present.sec, present.nanosec = divmod(time.time_ns(), 10**9)
        return present
    if hasattr(present, 'get_fields_and_field_types'):
        fill(present, value)
        return present
    element = message_class(re.sub(r'^sequence<|[>,\[].*$', '', kind))
    messages = [element() for _ in value]
    for message, values in zip(messages, value, strict=True):
        fill(message, values)
    return messages


def plain(value: Any, present: Any, kind: str) -> Any:
    """
    Return a value of a field that holds no message.

    :param value: as YAML gives it, which takes 1 for a whole number and not for a float.
    :param present: what is in the field.
    """
    if isinstance(value, list):
        is_real = 'double' in kind or 'float' in kind
        return [float(one) if is_real else one for one in value]
    if isinstance(present, float) and isinstance(value, int):
        return float(value)
    if isinstance(present, bytes) and isinstance(value, str):
        return value.encode('latin-1')
    return value
