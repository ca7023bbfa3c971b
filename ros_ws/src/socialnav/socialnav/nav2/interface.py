"""Everything by which nav2 commands a node, where nav2_msgs is installed."""

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

from rclpy.lifecycle import LifecycleNode

from socialnav.control.controller import Controller
from socialnav.control.decisions import Decision
from socialnav.control.speed_limit import SpeedLimit
from socialnav.nav2.follow_path import FollowPathServer
from socialnav.nav2.light_action import follow_path_type
from socialnav.nav2.speed_limits import SpeedLimits

ABSENT = 'nav2_msgs is not installed: the action follow_path is not offered'


CLEARING = 'local_costmap/clear_entirely_local_costmap'


class Nav2Interface:
    """The action follow_path, the topic speed_limit, and a service that nav2's trees wait for."""

    def __init__(
        self,
        node: LifecycleNode,
        controller: Controller,
        stand: Callable[[Decision], None],
        limit: Callable[[SpeedLimit], None],
        in_place: bool,
    ) -> None:
        """
        Offer them; paths are refused until the node drives.

        :param stand: publishes a decision to stand.
        :param limit: takes each limit of speed.
        :param in_place: whether the node is in the place of controller_server, which has a local
            costmap: trees of bt_navigator clear it, and do not start without that service.
        """
        from nav2_msgs.srv import ClearEntireCostmap

        self.node = node
        self.follower = FollowPathServer(node, follow_path_type(), controller, stand)
        self.limits = SpeedLimits(node, limit)
        self.clearing = None
        if in_place:
            self.clearing = node.create_service(ClearEntireCostmap, CLEARING, self.on_clear)

    def on_clear(self, _: Any, response: Any) -> Any:
        """Answer that nothing is left of what was seen long ago: obstacles are told anew."""
        return response

    def close(self) -> None:
        """Give them up."""
        self.follower.close()
        self.limits.close()
        if self.clearing is not None:
            self.node.destroy_service(self.clearing)


def is_installed() -> bool:
    """Return whether nav2's interfaces are there."""
    return find_spec('nav2_msgs') is not None
