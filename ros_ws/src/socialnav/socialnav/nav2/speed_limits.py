"""The topic speed_limit, on which nav2's filters say how fast a robot may drive."""

from collections.abc import Callable
from typing import Any

from rclpy.node import Node

from socialnav import qos
from socialnav.control.speed_limit import complaint, SpeedLimit


class SpeedLimits:
    """Hears limits and hands them on."""

    def __init__(self, node: Node, use: Callable[[SpeedLimit], None]) -> None:
        """
        Listen.

        :param use: takes each limit.
        :raises ImportError: nav2_msgs is not installed.
        """
        from nav2_msgs.msg import SpeedLimit as Message

        self.node = node
        self.use = use
        self.subscription = node.create_subscription(
            Message, 'speed_limit', self.on_limit, qos.SPEED_LIMIT
        )

    def on_limit(self, message: Any) -> None:
        """Hand on a limit, unless it is none."""
        limit = SpeedLimit(message.speed_limit, message.percentage)
        text = complaint(limit)
        if text is not None:
            self.node.get_logger().warning(text, throttle_duration_sec=1.0)
            return
        self.use(limit)

    def close(self) -> None:
        """Stop listening."""
        self.node.destroy_subscription(self.subscription)
