"""The sign of life that nav2's lifecycle manager waits for after it has activated a node."""

from importlib.util import find_spec
import uuid

from rclpy.clock import Clock, ClockType
from rclpy.node import Node

from socialnav import qos
from socialnav.messages.stamps import time_message

PERIOD = 0.1
"""Time between two signs, s, as nav2's nodes have it."""
PATIENCE = 4.0
"""Time without a sign after which the node counts as dead, s."""


class Bond:
    """
    Says that a node lives, under its name, until it is closed.

    The manager watches the node; the node need not watch the manager.
    """

    def __init__(self, node: Node) -> None:
        """
        Begin.

        :raises ImportError: the package bond is not installed.
        """
        from bond.msg import Status

        self.node = node
        self.kind = Status
        self.instance = str(uuid.uuid4())
        self.publisher = node.create_publisher(Status, 'bond', qos.BOND)
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self.timer = node.create_timer(PERIOD, self.tell, clock=steady)
        self.tell()

    def tell(self, active: bool = True) -> None:
        """
        Publish a sign of life, or that this was the last one.

        :param active: False for the last one.
        """
        status = self.kind(
            id=self.node.get_name(), instance_id=self.instance, active=active,
            heartbeat_period=PERIOD, heartbeat_timeout=PATIENCE,
        )  # fmt: skip
        status.header.stamp = time_message(self.node.get_clock().now().nanoseconds)
        self.publisher.publish(status)

    def close(self) -> None:
        """Say that this was the last sign, so that nobody waits for another."""
        self.tell(active=False)
        self.node.destroy_timer(self.timer)
        self.node.destroy_publisher(self.publisher)


def bond_of(node: Node, managed: bool) -> Bond | None:
    """
    Return the bond of a node.

    :param managed: whether somebody else activates the node; else nobody waits for a bond.
    """
    return Bond(node) if managed and find_spec('bond') is not None else None
