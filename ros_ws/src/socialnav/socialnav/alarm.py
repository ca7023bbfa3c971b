"""Calls back once, at a moment on the clock of a node."""

from collections.abc import Callable

from rclpy.node import Node

SOONEST = 0.001
"""Shortest time until an alarm, s."""


class Alarm:
    """A timer that rings once each time that it is set."""

    def __init__(self, node: Node, on_ring: Callable[[], None]) -> None:
        """
        Do not ring yet.

        :param node: whose clock counts and whose executor calls.
        :param on_ring: may set the alarm again.
        """
        self._node = node
        self._on_ring = on_ring
        self._timer = node.create_timer(1.0, self._ring, autostart=False)

    def set(self, delay: float) -> None:
        """
        Ring after some time, whatever was set before.

        :param delay: s, on the clock of the node.
        """
        self._timer.timer_period_ns = 1e9 * max(SOONEST, delay)
        self._timer.reset()

    def close(self) -> None:
        """Ring no more."""
        self._node.destroy_timer(self._timer)

    def _ring(self) -> None:
        self._timer.cancel()
        self._on_ring()
