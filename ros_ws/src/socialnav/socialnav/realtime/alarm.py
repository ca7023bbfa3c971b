"""Calls back once, at some moment."""

from collections.abc import Callable

from rclpy.clock import Clock
from rclpy.node import Node

SOONEST = 0.001
"""Shortest time until an alarm, s."""


class Alarm:
    """A timer that rings once each time that it is set."""

    def __init__(
        self, node: Node, on_ring: Callable[[], None], clock: Clock | None = None
    ) -> None:
        """
        Do not ring yet.

        :param node: whose executor calls.
        :param on_ring: may set the alarm again.
        :param clock: counts; None for that of the node.
        """
        self._node = node
        self._on_ring = on_ring
        self._closed = False
        self._timer = node.create_timer(1.0, self._ring, clock=clock, autostart=False)

    def set(self, delay: float) -> None:
        """Ring after some seconds, whatever was set before."""
        self._timer.timer_period_ns = 1e9 * max(SOONEST, delay)
        self._timer.reset()

    def close(self) -> None:
        """Ring no more, not even where the executor has been told already."""
        self._closed = True
        self._node.destroy_timer(self._timer)

    def _ring(self) -> None:
        if self._closed:
            return
        self._timer.cancel()
        self._on_ring()
