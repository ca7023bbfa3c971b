"""Calls of services that are known only by name."""

import time
from typing import Any

from lifecycle_msgs.srv import ChangeState
from rcl_interfaces.srv import SetParameters
from rclpy.node import Node

from small_ros2.command import CommandError
from small_ros2.graph import comes, node_names, PATIENCE, spin

ANSWER_TIME = 10.0
"""Time that a service may take to answer, s."""
UNSEEN_MATCH = 0.2
"""Time that a service is given to hear of its client, s; what it answers before that is lost."""
TRIES = 4
"""How often a question that changes nothing is asked before its answer is given up."""
CHANGING = (ChangeState, SetParameters)
"""Services that must not be called twice."""


def absolute(node_name: str) -> str:
    """Return the full name of a node, given with or without the first slash."""
    return '/' + node_name.lstrip('/')


def full_names(node: Node, hidden: bool = False) -> list[str]:
    """
    Return the full names of the nodes that have been seen, in order.

    :param hidden: names that begin with an underscore too.
    """
    pairs = node_names(node, hidden)
    return sorted(f'{namespace.rstrip("/")}/{name}' for name, namespace in pairs)


def ask(node: Node, kind: type, owner: str, service: str, request: Any) -> Any:
    """
    Return the response of a service of a node.

    :param owner: full name of the node that has it.
    :param service: its name within that node.
    :raises CommandError: when there is no such node, or it does not answer.
    """
    client = node.create_client(kind, f'{owner}/{service}')
    try:
        if not comes(client.service_is_ready, PATIENCE):
            known = owner in full_names(node, True)
            raise CommandError('Wait for service timed out' if known else 'Node not found')
        return response_of(node, client, request, 1 if kind in CHANGING else TRIES)
    finally:
        node.destroy_client(client)


def response_of(node: Node, client: Any, request: Any, tries: int = 1) -> Any:
    """
    Return the response of a service that is there.

    :param tries: how often to ask before no answer counts as none.
    :raises CommandError: when no answer comes.
    """
    time.sleep(UNSEEN_MATCH)
    for _ in range(tries):
        future = client.call_async(request)
        spin(node, future, ANSWER_TIME / tries)
        if future.done():
            break
    else:
        raise CommandError(f'{client.srv_name} did not answer within {ANSWER_TIME:g} s')
    if future.exception() is not None:
        raise CommandError(f'Exception while calling service: {future.exception()!r}')
    return future.result()
