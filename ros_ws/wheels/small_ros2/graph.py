"""A hidden node that looks at the graph, and waits until it has seen enough of it."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
import math
import os
import signal
import sys
import time

import rclpy
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from rclpy.task import Future

QUIET = 0.5
"""Time without a change after which the graph counts as known, s."""
PATIENCE = 3.0
"""Time after which what has not been seen is taken not to be there, s."""
POLL = 0.02
"""Time between two looks at the graph, s."""
WAKE_UP = 0.05
"""How often a node that is served looks for a signal, s."""
ENDING = (signal.SIGINT, signal.SIGTERM)
"""Signals that end a command."""
noted: list[int] = []
"""Those that have come."""


@contextmanager
def probe() -> Iterator[Node]:
    """
    Yield a node that other nodes do not see in their lists; ROS ends with it.

    ENDING signals are noted until heed() looks at them: an exception out of a handler may come
    where rclpy's C++ calls Python and cannot pass it on, and rclpy's own thread for signals ends
    ROS while this one may be ending it too.
    """
    for number in ENDING:
        signal.signal(number, lambda received, _: noted.append(received))
    rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
    try:
        yield rclpy.create_node(
            f'_ros2cli_{os.getpid()}', enable_rosout=False, start_parameter_services=False
        )
    finally:
        rclpy.try_shutdown()


def heed() -> None:
    """
    Leave the program if an ENDING signal has come.

    :raises KeyboardInterrupt: after SIGINT.
    :raises SystemExit: after SIGTERM.
    """
    if signal.SIGINT in noted:
        raise KeyboardInterrupt
    if noted:
        sys.exit(128 + noted[0])


def pause() -> None:
    """Wait for a moment between two looks at the graph; heed signals."""
    time.sleep(POLL)
    heed()


def comes(wanted: Callable[[], object], patience: float) -> bool:
    """
    Wait until something is there; return whether it is.

    :param patience: longest time to wait, s.
    """
    deadline = time.monotonic() + patience
    while not wanted():
        if time.monotonic() > deadline:
            return False
        pause()
    return True


def spin(node: Node, done: Future, patience: float = math.inf) -> None:
    """
    Serve a node until something is done.

    :param patience: time after which it ends all the same, s.
    """
    deadline = time.monotonic() + patience
    while not done.done() and (left := deadline - time.monotonic()) > 0.0:
        rclpy.spin_until_future_complete(node, done, timeout_sec=min(left, WAKE_UP))
        heed()


def look(node: Node, wanted: Callable[[], object]) -> bool:
    """Wait until something is there and the graph has come to rest; return whether it is there."""
    deadline = time.monotonic() + PATIENCE
    before, since = snapshot(node), time.monotonic()
    while (now := time.monotonic()) < deadline:
        after = snapshot(node)
        if after != before:
            before, since = after, now
        if now - since >= QUIET and wanted():
            return True
        pause()
    return bool(wanted())


def snapshot(node: Node) -> tuple:
    """Return what is known of the graph at present."""
    topics = [name for name, _ in node.get_topic_names_and_types()]
    counts = [(name, node.count_publishers(name), node.count_subscribers(name)) for name in topics]
    return sorted(node.get_node_names_and_namespaces()), sorted(counts)


def node_names(node: Node, hidden: bool = False) -> list[tuple[str, str]]:
    """
    Return the (name, namespace) of each node, this one left out.

    :param hidden: names that begin with an underscore too.
    """
    names = node.get_node_names_and_namespaces()
    own = (node.get_name(), node.get_namespace())
    return [pair for pair in names if pair != own and (hidden or not pair[0].startswith('_'))]


def visible(names_and_types: list[tuple[str, list[str]]]) -> list[tuple[str, list[str]]]:
    """Return names with their types in order, hidden ones (/_name) left out."""
    return [pair for pair in sorted(names_and_types) if '/_' not in pair[0]]
