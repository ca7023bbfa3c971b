"""`ros2 param dump`: all parameters of a node, as a file of parameters has them."""

import argparse
from array import array
from typing import Any

from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, parameter_value_to_python
import yaml

from small_ros2.clients import absolute, ask
from small_ros2.graph import probe


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument('node_name', help='full name, with namespace')
    parser.set_defaults(command=dump)


def dump(options: argparse.Namespace) -> None:
    """Print all parameters of a node as YAML."""
    owner = absolute(options.node_name)
    with probe() as node:
        listed = ask(node, ListParameters, owner, 'list_parameters', ListParameters.Request())
        request = GetParameters.Request(names=sorted(listed.result.names))
        values = ask(node, GetParameters, owner, 'get_parameters', request).values
    parameters: dict[str, Any] = {}
    for name, value in zip(request.names, values, strict=True):
        insert(parameters, name, plain(parameter_value_to_python(value)))
    print(yaml.dump({owner: {'ros__parameters': parameters}}, default_flow_style=False), end='')


def plain(value: Any) -> Any:
    """Return a value as YAML can tell it: arrays and bytes become lists."""
    return list(value) if isinstance(value, array | tuple) else value


def insert(parameters: dict[str, Any], name: str, value: Any) -> None:
    """Put a value into nested mappings, one for each part of its dotted name but the last."""
    *groups, last = name.split(PARAMETER_SEPARATOR_STRING)
    for group in groups:
        parameters = parameters.setdefault(group, {})
    parameters[last] = value
