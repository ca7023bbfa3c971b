"""`ros2 service`: the services of the graph."""

import argparse
from importlib import import_module

from small_ros2.clients import response_of
from small_ros2.command import CommandError
from small_ros2.filling import filled
from small_ros2.graph import comes, look, node_names, probe, visible

PATIENCE = 10.0
"""Time to wait for a service that is not there yet, s; ros2cli waits for ever."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the group."""
    verbs = parser.add_subparsers(metavar='VERB', required=True)
    verb = verbs.add_parser('list', help='print the names of the services')
    verb.add_argument('-t', '--show-types', action='store_true', help='with their types')
    verb.set_defaults(command=list_services)
    verb = verbs.add_parser('call', help='call a service and print its response')
    verb.add_argument('service_name', help='for instance /simulator_node/pause')
    verb.add_argument('service_type', help='for instance std_srvs/srv/SetBool')
    verb.add_argument('values', nargs='?', default='{}', help='request as YAML')
    verb.set_defaults(command=call)


def list_services(options: argparse.Namespace) -> None:
    """Print the names of the services."""
    with probe() as node:
        look(node, lambda: node_names(node))
        for name, types in visible(node.get_service_names_and_types()):
            print(f'{name} [{", ".join(types)}]' if options.show_types else name)


def call(options: argparse.Namespace) -> None:
    """Call a service and print request and response."""
    kind = service_class(options.service_type)
    request = filled(kind.Request, options.values)
    with probe() as node:
        client = node.create_client(kind, options.service_name)
        if not client.service_is_ready():
            print('waiting for service to become available...')
            if not comes(client.service_is_ready, PATIENCE):
                raise CommandError(f'{client.srv_name} did not appear within {PATIENCE:g} s')
        print(f'requester: making request: {request!r}\n')
        print(f'response:\n{response_of(node, client, request)!r}\n')


def service_class(name: str) -> type:
    """
    Return the class of a type of service.

    :param name: for instance std_srvs/srv/SetBool.
    :raises CommandError: when no sourced workspace has it.
    """
    package, _, kind = name.partition('/')
    try:
        return getattr(import_module(f'{package}.srv'), kind.removeprefix('srv/'))
    except (ImportError, AttributeError, TypeError, ValueError) as error:
        raise CommandError('The passed service type is invalid') from error
