"""`ros2 node`: the nodes of the graph."""

import argparse
from collections import Counter

from rclpy.action import (
    get_action_client_names_and_types_by_node,
    get_action_server_names_and_types_by_node,
)
from rclpy.node import Node

from small_ros2.command import CommandError
from small_ros2.graph import look, node_names, probe, visible


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the group."""
    verbs = parser.add_subparsers(metavar='VERB', required=True)
    verb = verbs.add_parser('list', help='print the names of the nodes')
    verb.add_argument('-a', '--all', action='store_true', help='hidden nodes too')
    verb.set_defaults(command=list_nodes)
    verb = verbs.add_parser('info', help='print what a node offers and uses')
    verb.add_argument('node_name', help='full name, with namespace')
    verb.set_defaults(command=info)


def full_name(name: str, namespace: str) -> str:
    """Return the name of a node with its namespace."""
    return f'{namespace.rstrip("/")}/{name}'


def list_nodes(options: argparse.Namespace) -> None:
    """Print the names of the nodes."""
    with probe() as node:
        look(node, lambda: node_names(node))
        names = sorted(full_name(*pair) for pair in node_names(node, options.all))
    if max(Counter(names).values(), default=0) > 1:
        print('WARNING: Be aware that there are nodes in the graph that share an exact name.')
    print(*names, sep='\n', end='\n' if names else '')


def info(options: argparse.Namespace) -> None:
    """Print what a node offers and uses."""
    wanted = '/' + options.node_name.lstrip('/')
    with probe() as node:

        def found() -> list[tuple[str, str]]:
            return [pair for pair in node_names(node, True) if full_name(*pair) == wanted]

        if not look(node, found):
            raise CommandError(f"Unable to find node '{options.node_name}'")
        print(wanted)
        for title, names_and_types in interfaces(node, *found()[0]).items():
            print(f'  {title}:')
            lines = [f'    {name}: {", ".join(types)}' for name, types in visible(names_and_types)]
            print(*lines, sep='\n')


def interfaces(node: Node, name: str, namespace: str) -> dict[str, list]:
    """Return the names and types of each kind of interface of a node."""
    return {
        'Subscribers': node.get_subscriber_names_and_types_by_node(name, namespace),
        'Publishers': node.get_publisher_names_and_types_by_node(name, namespace),
        'Service Servers': node.get_service_names_and_types_by_node(name, namespace),
        'Service Clients': node.get_client_names_and_types_by_node(name, namespace),
        'Action Servers': get_action_server_names_and_types_by_node(node, name, namespace),
        'Action Clients': get_action_client_names_and_types_by_node(node, name, namespace),
    }
