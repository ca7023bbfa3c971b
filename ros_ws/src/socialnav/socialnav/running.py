"""Run a node until it is told to stop, and let it say its last word."""

from collections.abc import Callable
from pathlib import Path
import signal
import sys

import rclpy
from rclpy.executors import Executor
from rclpy.experimental import EventsExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

from socialnav.programs import STOPPING, take_signals
from socialnav_core.allocator import give_back_large_blocks

WAKE_UP = 0.05
"""How often a waiting node looks whether it should stop, s."""


def run(build: Callable[[], Node]) -> int:
    """
    Build a node, spin it until a signal of STOPPING and return the exit code of the process.

    The signals are taken here and not by rclpy, whose handlers end publishing at once.

    :param build: makes the node, which has a method close(); a ValueError that it raises is the
        user's mistake and becomes one line.
    """
    signals: list[int] = []  # an event would hang where a second signal interrupts its set()
    take_signals(lambda number, _: signals.append(number))
    give_back_large_blocks()  # of messages that are too long
    try:
        rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    except RuntimeError as error:  # arguments that rcl cannot read
        return failure(error)
    try:
        node = build()
    except ValueError as error:
        rclpy.try_shutdown()
        return failure(error)
    try:
        spin(node, signals)
    finally:
        rclpy.try_shutdown()
        for number in STOPPING:  # a second one while Python ends would kill it
            signal.signal(number, signal.SIG_IGN)
    return 0


def failure(error: Exception) -> int:
    """Print one line about a mistake of the user and return the exit code for it."""
    print(f'{Path(sys.argv[0]).name}: {error}', file=sys.stderr)
    return 1


def spin(node: Node, signals: list[int]) -> None:
    """
    Serve a node until a signal has come, then close it.

    rclpy's executor of events costs half the processor time of those that build a wait set in
    Python before each callback.

    :param node: it has close(), which may still publish.
    :param signals: that have come so far.
    """
    executor = EventsExecutor()
    executor.add_node(node)
    try:
        while not signals:
            serve(executor, node)
    finally:
        node.close()  # type: ignore[attr-defined]
        executor.shutdown()
        node.destroy_node()


def serve(executor: Executor, node: Node) -> None:
    """
    Serve one callback of a node, or wait for a while.

    rclpy raises where another process asks a managed node for a transition that its state does
    not have; such a request must not end the node.
    """
    try:
        executor.spin_once(timeout_sec=WAKE_UP)
    except rclpy_implementation.RCLError as error:
        node.get_logger().error(f'refused: {error}', throttle_duration_sec=1.0)
