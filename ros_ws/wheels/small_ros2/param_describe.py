"""`ros2 param describe`: what is known of parameters."""

import argparse

from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from rcl_interfaces.srv import DescribeParameters
from rclpy.node import Node

from small_ros2.clients import absolute, ask
from small_ros2.command import CommandError
from small_ros2.graph import probe

FIELDS = {
    getattr(ParameterType, f'PARAMETER_{name.upper()}'): f'{name}_value'
    for kind in ('bool', 'integer', 'double', 'string', 'byte')
    for name in (kind, f'{kind}_array')
    if name != 'byte'
}
"""Which field of a value holds it, by the type of the parameter."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument('node_name', help='full name, with namespace')
    parser.add_argument('parameter_names', nargs='+', help='names of the parameters')
    parser.set_defaults(command=describe)


def type_name(number: int) -> str:
    """Return what a type of parameter, one of ParameterType, is called."""
    words = FIELDS.get(number, 'not set').removesuffix('_value').replace('_', ' ')
    return words.replace('bool', 'boolean')


def describe(options: argparse.Namespace) -> None:
    """Print what is known of parameters."""
    with probe() as node:
        for one in descriptors(node, absolute(options.node_name), options.parameter_names):
            print(description(one))


def descriptors(node: Node, owner: str, names: list[str]) -> list[ParameterDescriptor]:
    """
    Return the descriptors of parameters of a node.

    :param owner: full name of the node.
    :raises CommandError: when the node does not have one of them.
    """
    request = DescribeParameters.Request(names=names)
    known = ask(node, DescribeParameters, owner, 'describe_parameters', request).descriptors
    if len(known) < len(names):
        raise CommandError('Parameter not set')
    return known


def description(descriptor: ParameterDescriptor) -> str:
    """Return what is known of a parameter, as text."""
    lines = [f'Parameter name: {descriptor.name}', f'  Type: {type_name(descriptor.type)}']
    if descriptor.description:
        lines.append(f'  Description: {descriptor.description}')
    lines.append('  Constraints:')
    if descriptor.read_only:
        lines.append('    Read only: true')
    for limits in [*descriptor.floating_point_range, *descriptor.integer_range]:
        lines.append(f'    Min value: {limits.from_value}')
        lines.append(f'    Max value: {limits.to_value}')
        if limits.step:
            lines.append(f'    Step: {limits.step}')
    if descriptor.additional_constraints:
        lines.append(f'    Additional constraints: {descriptor.additional_constraints}')
    return '\n'.join(lines)
