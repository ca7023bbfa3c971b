"""The node that turns laser scans, or a grid, into obstacles."""

from collections.abc import Callable
from functools import partial
import sys
from typing import Any

from nav_msgs.msg import OccupancyGrid, Odometry
from rclpy.node import Node
from rclpy.parameter import Parameter
from sensor_msgs.msg import LaserScan

from socialnav import qos
from socialnav.health import Health
from socialnav.messages.conversions import ConversionError
from socialnav.messages.sources import new_source
from socialnav.messages.transforms import Transforms
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
        self.transforms, source = Transforms(self), new_source(self.get_fully_qualified_name())
        self.finder = ObstacleFinder(settings, self.transforms.transform, source)
        self.health = Health(self)
        self.add_post_set_parameters_callback(self.on_parameters)
        self.obstacles = self.create_publisher(AgentStates, 'obstacles', qos.OBSTACLES)
        self.listen(Odometry, 'odom', self.finder.store_odometry, qos.SENSOR_INPUT)
        self.listen(AgentStates, 'pedestrians', self.finder.store_people, qos.SENSOR_INPUT)
        if settings.source == 'scan':
            for topic in self.finder.lasers.topics:
                take = partial(self.on_scan, topic)
                self.listen(LaserScan, topic, take, qos.SENSOR_INPUT)
        else:
            self.listen(OccupancyGrid, 'map', self.finder.store_grid, qos.MAP)
            period, tick = 1 / settings.grid_rate, partial(self.attempt, 'grid', self.on_tick)
            self.create_timer(period, tick, clock=pacing_clock(self))

    def listen(self, kind: type, topic: str, take: Callable[[Any], None], profile: Any) -> None:
        """
        Subscribe to an input.

        :param take: called with each message; may raise a ConversionError.
        """
        self.create_subscription(kind, topic, partial(self.attempt, topic, take), profile)

    def attempt(self, source: str, take: Callable[..., None], *message: Any) -> None:
        """Take a message; say why where it cannot be used."""
        try:
            take(*message)
        except ConversionError as error:
            self.health.bad(source, f'no obstacles: {error}')
        else:
            self.health.good(source)

    def on_parameters(self, changes: list[Parameter]) -> None:
        """Use parameters that were changed."""
        self.finder.settings = updated(self.finder.settings, changes)

    def on_scan(self, topic: str, message: LaserScan) -> None:
        """Answer a scan."""
        self.obstacles.publish(self.finder.of_scan(message, topic))
        self.health.answer()
        self.health.advise(self.finder.silence())

    def on_tick(self) -> None:
        """Publish what the grid says around the newest place of the robot."""
        obstacles = self.finder.of_grid()
        if obstacles is not None:
            self.obstacles.publish(obstacles)
            self.health.answer()

    def close(self) -> None:
        """Stop listening to transforms: obstacles that age are the policy's matter."""
        self.transforms.close()


def main() -> None:
    """Run the node."""
    sys.exit(run(ObstacleNode))
