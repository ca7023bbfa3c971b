"""Calls of services that are known only by name."""

from typing import Any

from rclpy.node import Node

from small_ros2.command import CommandError
from small_ros2.graph import comes, node_names, PATIENCE, spin

ANSWER_TIME = 10.0
"""Time that a service may take to answer, s."""


def absolute(node_name: str) -> str:
    """
    Return the full name of a node.

    :param node_name: with or without the first slash.
    """
    return '/' + node_name.lstrip('/')


def full_names(node: Node, hidden: bool = False) -> list[str]:
    """
    Return the full names of the nodes that have been seen, in order.

    :param node: that looks.
    :param hidden: names that begin with an underscore too.
    """
    pairs = node_names(node, hidden)
    return sorted(f'{namespace.rstrip("/")}/{name}' for name, namespace in pairs)


def ask(node: Node, kind: type, owner: str, service: str, request: Any) -> Any:
    """
    Return the response of a service of a node.

    :param node: that asks.
    :param kind: class of the service.
    :param owner: full name of the node that has it.
    :param service: its name within that node.
    :param request: what to ask.
    :raises CommandError: when there is no such node, or it does not answer.
    """
    client = node.create_client(kind, f'{owner}/{service}')
    try:
        if not comes(client.service_is_ready, PATIENCE):
            known = owner in full_names(node, True)
            raise CommandError('Wait for service timed out' if known else 'Node not found')
        return response_of(node, client, request)
    finally:
        node.destroy_client(client)


def response_of(node: Node, client: Any, request: Any) -> Any:
    """
    Return the response of a service that is there.

    :param node: that asks.
    :param client: of the service.
    :param request: what to ask.
    :raises CommandError: when no answer comes.
    """
    future = client.call_async(request)
    spin(node, future, ANSWER_TIME)
    if not future.done():
        raise CommandError(f'{client.srv_name} did not answer within {ANSWER_TIME:g} s')
    if future.exception() is not None:
        raise CommandError(f'Exception while calling service: {future.exception()!r}')
    return future.result()
