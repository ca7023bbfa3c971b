"""`ros2 param`: the parameters of the nodes; unlike ros2cli's, a refused `set` exits with 1."""

import argparse

from rcl_interfaces.msg import Parameter, ParameterValue
from rcl_interfaces.srv import GetParameters, ListParameters, SetParameters
from rclpy.node import Node
from rclpy.parameter import get_parameter_value
import yaml

from small_ros2 import param_describe, param_dump, param_load
from small_ros2.clients import absolute, ask, full_names
from small_ros2.command import CommandError
from small_ros2.graph import look, probe
from small_ros2.param_describe import descriptors, FIELDS, type_name


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the group."""
    verbs = parser.add_subparsers(metavar='VERB', required=True)
    verb = verbs.add_parser('list', help='print the names of the parameters')
    verb.add_argument('node_name', nargs='?', help='of this node only')
    verb.add_argument('--include-hidden-nodes', action='store_true', help='hidden nodes too')
    verb.add_argument('--param-prefixes', nargs='+', default=[], help='names that begin so')
    verb.add_argument('--param-type', action='store_true', help='with their types')
    verb.set_defaults(command=list_parameters)
    verb = verbs.add_parser('get', help='print the value of a parameter')
    verb.add_argument('node_name', help='full name, with namespace')
    verb.add_argument('parameter_name', help='name of the parameter')
    verb.add_argument('--hide-type', action='store_true', help='the value alone')
    verb.set_defaults(command=get)
    verb = verbs.add_parser('set', help='change a parameter')
    verb.add_argument('node_name', help='full name, with namespace')
    verb.add_argument('parameter_name', help='name of the parameter')
    verb.add_argument('value', help='as YAML, for instance 0.5 or [1, 2]')
    verb.set_defaults(command=set_parameter)
    for name, module, summary in (
        ('describe', param_describe, 'print what is known of a parameter'),
        ('dump', param_dump, 'print all parameters of a node as a file has them'),
        ('load', param_load, 'give a node the parameters of a file'),
    ):
        module.add_arguments(verbs.add_parser(name, help=summary))


def list_parameters(options: argparse.Namespace) -> None:
    """Print the names of the parameters of a node, or of each node."""
    with probe() as node:
        request = ListParameters.Request(prefixes=options.param_prefixes)
        for owner in owners(node, options):
            names = ask(node, ListParameters, owner, 'list_parameters', request).result.names
            if not options.node_name:
                print(f'{owner}:')
            kinds = {}
            if options.param_type:
                known = descriptors(node, owner, list(names))
                kinds = {one.name: f' (type: {type_name(one.type)})' for one in known}
            for name in sorted(names):
                print(f'  {name}{kinds.get(name, "")}')


def owners(node: Node, options: argparse.Namespace) -> list[str]:
    """Return the full names of the nodes whose parameters are wanted."""
    if options.node_name:
        return [absolute(options.node_name)]
    look(node, lambda: full_names(node))
    services = dict(node.get_service_names_and_types())
    names = full_names(node, options.include_hidden_nodes)
    return [name for name in names if f'{name}/list_parameters' in services]


def get(options: argparse.Namespace) -> None:
    """Print the value of a parameter."""
    with probe() as node:
        request = GetParameters.Request(names=[options.parameter_name])
        owner = absolute(options.node_name)
        values = ask(node, GetParameters, owner, 'get_parameters', request).values
    if not values:
        raise CommandError('Parameter not set')
    print(value_text(values[0], options.hide_type))


def value_text(value: ParameterValue, hide_type: bool) -> str:
    """Return a value as text."""
    content = getattr(value, FIELDS.get(value.type, ''), None)
    if hide_type:
        return str(content)
    if content is None:
        return 'Parameter not set.'
    kind = type_name(value.type)
    verb = 'values are' if kind.endswith(' array') else 'value is'
    return f'{kind.removesuffix(" array").capitalize()} {verb}: {content}'


def set_parameter(options: argparse.Namespace) -> None:
    """Change a parameter."""
    try:
        value = get_parameter_value(options.value)
    except (AssertionError, yaml.YAMLError) as error:
        raise CommandError(f"'{options.value}' is no value of a parameter") from error
    with probe() as node:
        request = SetParameters.Request(
            parameters=[Parameter(name=options.parameter_name, value=value)]
        )
        owner = absolute(options.node_name)
        result = ask(node, SetParameters, owner, 'set_parameters', request).results[0]
    reason = f': {result.reason}' if result.reason else ''
    if not result.successful:
        raise CommandError(f'Setting parameter failed{reason}')
    print(f'Set parameter successful{reason}')
