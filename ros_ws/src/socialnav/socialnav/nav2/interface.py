"""Everything by which nav2 commands a node, where nav2_msgs is installed."""

from collections.abc import Callable
from importlib.util import find_spec

from rclpy.lifecycle import LifecycleNode

from socialnav.control.controller import Controller
from socialnav.control.decisions import Decision
from socialnav.control.speed_limit import SpeedLimit
from socialnav.nav2.follow_path import FollowPathServer
from socialnav.nav2.light_action import follow_path_type
from socialnav.nav2.speed_limits import SpeedLimits

ABSENT = 'nav2_msgs is not installed: the action follow_path is not offered'


class Nav2Interface:
    """The action follow_path and the topic speed_limit."""

    def __init__(
        self,
        node: LifecycleNode,
        controller: Controller,
        stand: Callable[[Decision], None],
        limit: Callable[[SpeedLimit], None],
    ) -> None:
        """
        Offer them; paths are refused until the node drives.

        :param stand: publishes a decision to stand.
        :param limit: takes each limit of speed.
        """
        self.follower = FollowPathServer(node, follow_path_type(), controller, stand)
        self.limits = SpeedLimits(node, limit)

    def close(self) -> None:
        """Give them up."""
        self.follower.close()
        self.limits.close()


def is_installed() -> bool:
    """Return whether nav2's interfaces are there."""
    return find_spec('nav2_msgs') is not None
