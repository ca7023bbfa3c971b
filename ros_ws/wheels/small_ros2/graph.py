"""A hidden node that looks at the graph, and waits until it has seen enough of it."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
import os
import signal
import sys
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

QUIET = 0.5
"""Time without a change after which the graph counts as known, s."""
PATIENCE = 3.0
"""Time after which what has not been seen is taken not to be there, s."""
POLL = 0.02
"""Time between two looks at the graph, s."""


@contextmanager
def probe() -> Iterator[Node]:
    """Yield a node that other nodes do not see in their lists; ROS ends with it."""
    signal.signal(signal.SIGTERM, on_sigterm)
    rclpy.init(args=[])
    try:
        yield rclpy.create_node(
            f'_ros2cli_{os.getpid()}', enable_rosout=False, start_parameter_services=False
        )
    except ExternalShutdownException:
        # Ctrl-C, where Python was started with SIGINT ignored, as in the background of a script.
        raise KeyboardInterrupt from None
    finally:
        rclpy.try_shutdown()


def on_sigterm(number: int, _: object) -> None:
    """
    End the program in order; rclpy's own handler, which runs first, only ends ROS.

    :param number: of the signal.
    """
    sys.exit(128 + number)


def look(node: Node, wanted: Callable[[], object]) -> bool:
    """
    Wait until something is there and the graph has come to rest; return whether it is there.

    :param node: that looks.
    :param wanted: true when it is there.
    """
    deadline = time.monotonic() + PATIENCE
    before, since = snapshot(node), time.monotonic()
    while (now := time.monotonic()) < deadline:
        after = snapshot(node)
        if after != before:
            before, since = after, now
        if now - since >= QUIET and wanted():
            return True
        time.sleep(POLL)
    return bool(wanted())


def snapshot(node: Node) -> tuple:
    """
    Return what is known of the graph at present.

    :param node: that looks.
    """
    topics = [name for name, _ in node.get_topic_names_and_types()]
    counts = [(name, node.count_publishers(name), node.count_subscribers(name)) for name in topics]
    return sorted(node.get_node_names_and_namespaces()), sorted(counts)


def node_names(node: Node, hidden: bool = False) -> list[tuple[str, str]]:
    """
    Return the (name, namespace) of each node, this one left out.

    :param node: that looks.
    :param hidden: names that begin with an underscore too.
    """
    names = node.get_node_names_and_namespaces()
    own = (node.get_name(), node.get_namespace())
    return [pair for pair in names if pair != own and (hidden or not pair[0].startswith('_'))]


def visible(names_and_types: list[tuple[str, list[str]]]) -> list[tuple[str, list[str]]]:
    """
    Return names with their types in order, hidden ones (/_name) left out.

    :param names_and_types: of topics, services or actions.
    """
    return [pair for pair in sorted(names_and_types) if '/_' not in pair[0]]
