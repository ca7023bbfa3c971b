"""The node that turns a laser scan, or a grid, into obstacles."""

from collections.abc import Callable
from functools import partial
import sys
from typing import Any

from nav_msgs.msg import OccupancyGrid, Odometry
from rclpy.node import Node
from rclpy.parameter import Parameter
from sensor_msgs.msg import LaserScan

from socialnav import qos
from socialnav.messages.conversions import ConversionError
from socialnav.parameters.declaring import declare, updated
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.perception.obstacle_finder import ObstacleFinder
from socialnav.realtime.clocks import pacing_clock
from socialnav.running import run
from socialnav_msgs.msg import AgentStates


class ObstacleNode(Node):
    """Answers each scan, or each odometry while there is a grid, with obstacles."""

    def __init__(self) -> None:
        """
        Listen.

        :raises ParameterError: a parameter that cannot be used.
        """
        super().__init__('obstacle_node')
        settings = declare(self, ObstacleParameters)
        self.finder = ObstacleFinder(settings)
        self.add_post_set_parameters_callback(self.on_parameters)
        self.obstacles = self.create_publisher(AgentStates, 'obstacles', qos.OBSTACLES)
        self.listen(Odometry, 'odom', self.finder.store_odometry, qos.SENSOR_INPUT)
        self.listen(AgentStates, 'pedestrians', self.finder.store_people, qos.SENSOR_INPUT)
        if settings.source == 'scan':
            self.listen(LaserScan, 'scan', self.on_scan, qos.SENSOR_INPUT)
        else:
            self.listen(OccupancyGrid, 'map', self.finder.store_grid, qos.MAP)
            period, tick = 1 / settings.grid_rate, partial(self.attempt, self.on_tick)
            self.create_timer(period, tick, clock=pacing_clock(self))

    def listen(self, kind: type, topic: str, take: Callable[[Any], None], profile: Any) -> None:
        """
        Subscribe to an input.

        :param take: called with each message; may raise a ConversionError.
        """
        self.create_subscription(kind, topic, partial(self.attempt, take), profile)

    def attempt(self, take: Callable[..., None], *message: Any) -> None:
        """Take a message; say why where it cannot be used."""
        try:
            take(*message)
        except ConversionError as error:
            self.get_logger().warning(f'no obstacles: {error}', throttle_duration_sec=1.0)

    def on_parameters(self, changes: list[Parameter]) -> None:
        """Use parameters that were changed."""
        self.finder.settings = updated(self.finder.settings, changes)

    def on_scan(self, message: LaserScan) -> None:
        """Answer a scan."""
        self.obstacles.publish(self.finder.of_scan(message))

    def on_tick(self) -> None:
        """Publish what the grid says around the newest place of the robot."""
        obstacles = self.finder.of_grid()
        if obstacles is not None:
            self.obstacles.publish(obstacles)

    def close(self) -> None:
        """Do nothing: obstacles that age are the policy's matter."""


def main() -> None:
    """Run the node."""
    sys.exit(run(ObstacleNode))
