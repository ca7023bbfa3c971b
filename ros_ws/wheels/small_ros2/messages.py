"""Message classes by name, and messages as YAML in the form of `ros2 topic echo`."""

from array import array
from importlib import import_module
from typing import Any

import numpy as np
import yaml

from small_ros2.command import CommandError

DUMPER = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)
NO_WRAP = 2**31 - 1


def message_class(name: str) -> type:
    """
    Return the class of a type of message.

    :param name: for instance std_msgs/msg/String.
    :raises CommandError: when no sourced workspace has it.
    """
    package, _, kind = name.partition('/')
    try:
        return getattr(import_module(f'{package}.msg'), kind.removeprefix('msg/'))
    except (ImportError, AttributeError, TypeError, ValueError) as error:
        raise CommandError(f"The message type '{name}' is invalid") from error


def message_text(message: Any, longest: int | None) -> str:
    """
    Return a message as YAML.

    :param longest: elements of arrays and characters of strings to show; all when none.
    """
    return yaml.dump(
        plain(message, longest), Dumper=DUMPER, sort_keys=False, allow_unicode=True,
        width=NO_WRAP, default_flow_style=False,
    )  # fmt: skip


def plain(value: Any, longest: int | None) -> Any:
    """
    Return a value of a field as dictionaries, lists, strings and numbers.

    :param longest: elements of arrays and characters of strings to show; all when none.
    """
    if hasattr(value, 'get_fields_and_field_types'):
        fields = value.get_fields_and_field_types()
        return {field: plain(getattr(value, field), longest) for field in fields}
    if isinstance(value, bytes):
        value = value.decode('latin-1')
    if isinstance(value, str):
        return value if longest is None or len(value) <= longest else value[:longest] + '...'
    if isinstance(value, (list, tuple, array, np.ndarray)):
        shown = [plain(element, longest) for element in value[:longest]]
        return shown if len(shown) == len(value) else [*shown, '...']
    return value.item() if isinstance(value, np.generic) else value
