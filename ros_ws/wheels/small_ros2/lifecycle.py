"""`ros2 lifecycle`: managed nodes; unlike ros2cli's, a failed `set` exits with 1."""

import argparse

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from rclpy.node import Node

from small_ros2.clients import absolute, ask, full_names
from small_ros2.command import CommandError
from small_ros2.graph import look, probe

STATE_TYPE = 'lifecycle_msgs/srv/GetState'


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the group."""
    verbs = parser.add_subparsers(metavar='VERB', required=True)
    verb = verbs.add_parser('nodes', help='print the names of the managed nodes')
    verb.add_argument('-a', '--all', action='store_true', help='hidden nodes too')
    verb.set_defaults(command=list_nodes)
    verb = verbs.add_parser('get', help='print the state of a node, or of each managed node')
    verb.add_argument('node_name', nargs='?', help='full name, with namespace')
    verb.set_defaults(command=get)
    verb = verbs.add_parser('set', help='trigger a transition')
    verb.add_argument('node_name', help='full name, with namespace')
    verb.add_argument('transition', help='its label or number, for instance activate')
    verb.set_defaults(command=set_state)


def managed_nodes(node: Node, hidden: bool = False) -> list[str]:
    """
    Return the full names of the managed nodes.

    :param hidden: names that begin with an underscore too.
    """
    look(node, lambda: full_names(node, hidden))
    services = dict(node.get_service_names_and_types())
    names = full_names(node, hidden)
    return [name for name in names if STATE_TYPE in services.get(f'{name}/get_state', ())]


def list_nodes(options: argparse.Namespace) -> None:
    """Print the names of the managed nodes."""
    with probe() as node:
        for name in managed_nodes(node, options.all):
            print(name)


def get(options: argparse.Namespace) -> None:
    """Print the state of a node, or of each managed node."""
    with probe() as node:
        wanted = [absolute(options.node_name)] if options.node_name else managed_nodes(node)
        for name in wanted:
            state = ask(node, GetState, name, 'get_state', GetState.Request()).current_state
            prefix = '' if options.node_name else f'{name}: '
            print(f'{prefix}{state.label} [{state.id}]')


def set_state(options: argparse.Namespace) -> None:
    """Trigger a transition of a node."""
    name = absolute(options.node_name)
    with probe() as node:
        transition = chosen(available(node, name), options.transition)
        request = ChangeState.Request(transition=transition)
        if not ask(node, ChangeState, name, 'change_state', request).success:
            raise CommandError('Transitioning failed')
    print('Transitioning successful')


def available(node: Node, name: str) -> list[Transition]:
    """
    Return the transitions that a node can make from its present state.

    :param name: full name of the other node.
    """
    request = GetAvailableTransitions.Request()
    response = ask(node, GetAvailableTransitions, name, 'get_available_transitions', request)
    return [description.transition for description in response.available_transitions]


def chosen(transitions: list[Transition], wanted: str) -> Transition:
    """
    Return the transition that is meant.

    :param wanted: label or number of one.
    :raises CommandError: when it cannot be made.
    """
    for transition in transitions:
        if wanted in (transition.label, str(transition.id)):
            return transition
    lines = [f'- {transition.label} [{transition.id}]' for transition in transitions]
    head = 'Unknown transition requested, available ones are:'
    raise CommandError('\n'.join([head, *lines]))
