"""From the dataclass of a node to parameters of rclpy, and from their values to the dataclass."""

from collections.abc import Callable, Iterable
import dataclasses
import sys
from typing import Any

from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    SetParametersResult,
)
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.node import Node
from rclpy.parameter import Parameter

from socialnav.parameters.addressees import unheard
from socialnav.parameters.fields import complaint, entries, Entry, requirement, Settings
from socialnav_core.config.mapping import number_from_text, unknown_key

OF_EVERY_NODE = ('use_sim_time', 'start_type_description_service', 'qos_overrides.')
"""How parameters begin that rclpy declares itself."""


class ParameterError(ValueError):
    """A parameter that a node cannot start with; the text is one line that says what to do."""


def declare(
    node: Node, kind: type[Settings], active: Callable[[], bool] = lambda: True
) -> Settings:
    """
    Declare all parameters of a node and return their values.

    What the command line says to other nodes alone is named in the log. From then on, a change is
    refused unless the parameter is live and the value in its range.

    :param active: tells whether the node drives.
    :raises ParameterError: a value of the wrong type or outside of its range, or an unknown name.
    """
    for line in unheard(sys.argv, node.get_fully_qualified_name()):
        node.get_logger().warning(line)
    table = entries(kind)
    refuse_unknown(node, [entry.name for entry in table])
    values = {entry.name: declared(node, entry) for entry in table}
    node.add_pre_set_parameters_callback(lambda changes: numbers_from_texts(table, changes))
    node.add_on_set_parameters_callback(lambda changes: judged(node, table, changes, active()))
    return dataclasses.replace(kind(), **values)


def updated(settings: Settings, changes: Iterable[Parameter]) -> Settings:
    """Return settings after changes; those of rclpy's own parameters do not concern them."""
    names = {entry.name for entry in entries(settings)}
    values = {one.name: one.value for one in changes if one.name in names}
    return dataclasses.replace(settings, **values)


def refuse_unknown(node: Node, known: list[str]) -> None:
    """
    Raise a ParameterError where a value was given to a parameter that does not exist.

    rclpy ignores it, so that a robot would drive with the default of what was mistyped; nothing
    that is public in rclpy tells what was given.
    """
    for name in node._parameter_overrides:
        if name not in known and not name.startswith(OF_EVERY_NODE):
            raise ParameterError(unknown_key('', name, known))


def declared(node: Node, entry: Entry) -> Any:
    """Declare one parameter and return its value."""
    try:
        value = node.declare_parameter(entry.name, entry.default, descriptor(entry)).value
    except (InvalidParameterTypeException, InvalidParameterValueException):
        raise ParameterError(f'parameter {entry.name} {requirement(entry)}') from None
    if (text := complaint(entry, value)) is not None:
        raise ParameterError(f'parameter {text}')
    return value


def descriptor(entry: Entry) -> ParameterDescriptor:
    """Return what `ros2 param describe` shows."""
    unit = f' [{entry.unit}]' if entry.unit else ''
    result = ParameterDescriptor(name=entry.name, description=entry.description + unit)
    result.additional_constraints = requirement(entry)
    if entry.range and isinstance(entry.default, int):
        low, high = entry.range
        result.integer_range = [IntegerRange(from_value=int(low), to_value=int(high), step=1)]
    elif entry.range:
        low, high = entry.range
        result.floating_point_range = [FloatingPointRange(from_value=low, to_value=high)]
    return result


def numbers_from_texts(table: tuple[Entry, ...], changes: list[Parameter]) -> list[Parameter]:
    """
    Return changes in which a text that is a number is one, where a number is wanted.

    What `ros2 param dump` writes comes back from `load` as text where Python's notation of a
    number is not YAML's: inf and 1e-05.
    """
    wanted = {entry.name for entry in table if isinstance(entry.default, float)}
    return [
        Parameter(one.name, value=number_from_text(one.value))
        if one.name in wanted and isinstance(one.value, str)
        else one
        for one in changes
    ]


def judged(
    node: Node, table: tuple[Entry, ...], changes: list[Parameter], active: bool
) -> SetParametersResult:
    """
    Return whether changes of a running node are accepted, and why not.

    :param active: whether the node drives.
    """
    known = {entry.name: entry for entry in table}
    for change in (one for one in changes if one.name in known):
        present = node.get_parameter(change.name).value
        reason = refusal(known[change.name], change.value, present, active)
        if reason is not None:
            return SetParametersResult(successful=False, reason=reason)
    return SetParametersResult(successful=True)


def refusal(entry: Entry, value: Any, present: Any, active: bool) -> str | None:
    """
    Return why a running node refuses a value, or None; what it has already is never refused.

    :param active: whether the node drives.
    """
    if value == present:
        return None
    if entry.live == 'no':
        return f'{entry.name} cannot change while the node runs: start it with another value'
    if entry.live == 'inactive' and active:
        return f'{entry.name} cannot change while the node drives: deactivate it first'
    return complaint(entry, value)
