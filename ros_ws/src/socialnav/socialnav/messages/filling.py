"""From plain mappings, as socialnav_core.messages makes them, to ROS messages."""

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import Any, TypeVar

Kind = TypeVar('Kind')


def filled(kind: type[Kind], content: Mapping[str, Any]) -> Kind:
    """
    Return a message of a type.

    :param content: values by field, mappings and lists of mappings for messages in it.
    :raises AttributeError: a field that the type does not have.
    """
    message = kind()
    fill(message, content)
    return message


def fill(message: Any, content: Mapping[str, Any]) -> None:
    """Set the fields that are named; the others stay."""
    for name, value in content.items():
        if isinstance(value, dict):  # fields that are messages have been made with their owner
            fill(getattr(message, name), value)
        elif isinstance(value, list):
            element = element_type(message.__class__, name)
            setattr(message, name, [filled(element, one) for one in value])
        else:
            setattr(message, name, value)


@cache
def element_type(kind: Any, name: str) -> Any:
    """Return the type of the messages that a field of a type lists."""
    fields = list(kind.get_fields_and_field_types())
    element = kind.SLOT_TYPES[fields.index(name)].value_type
    return getattr(import_module('.'.join(element.namespaces)), element.name)
