"""The node that turns detections of people into pedestrians with names and velocities."""

import sys
from typing import Any

from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.parameter import Parameter

from socialnav import qos
from socialnav.health import Health
from socialnav.messages.conversions import ConversionError
from socialnav.messages.detection_types import DETECTION_TYPES, message_class
from socialnav.messages.sensor_messages import detection_points, tracks_message
from socialnav.messages.sources import new_source
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters.declaring import declare, updated
from socialnav.parameters.tracker import TrackerParameters
from socialnav.perception.locating import Locator
from socialnav.perception.moments import Moments
from socialnav.perception.rate import Rate
from socialnav.running import run
from socialnav_core.sensing import Tracker, TrackerSettings
from socialnav_msgs.msg import AgentStates


class TrackerNode(Node):
    """Answers each message of detections with everybody who is there."""

    def __init__(self) -> None:
        """
        Listen.

        :raises ValueError: a parameter that cannot be used.
        """
        super().__init__('tracker_node')
        self.settings = declare(self, TrackerParameters)
        self.add_post_set_parameters_callback(self.on_parameters)
        frames = self.settings.planning_frame, self.settings.base_frame
        self.locator = Locator(*frames, self.settings.pose_timeout)
        self.tracker = Tracker(tracker_settings(self.settings))
        self.moments, self.rate, self.health = Moments(), Rate(), Health(self)
        self.source = new_source(self.get_fully_qualified_name())
        self.pedestrians = self.create_publisher(AgentStates, 'pedestrians', qos.PEDESTRIANS)
        self.kind = DETECTION_TYPES[self.settings.source]
        self.create_subscription(
            message_class(self.kind), 'detections', self.on_detections, qos.SENSOR_INPUT
        )
        self.create_subscription(Odometry, 'odom', self.on_odometry, qos.SENSOR_INPUT)

    def on_parameters(self, changes: list[Parameter]) -> None:
        """Use parameters that were changed."""
        self.settings = updated(self.settings, changes)
        self.tracker.settings = tracker_settings(self.settings)

    def on_odometry(self, message: Odometry) -> None:
        """Keep a pose of the robot, in whose frame detections may be."""
        try:
            self.locator.store(message)
        except ConversionError as error:
            self.health.bad('odom', f'ignored: {error}')
        else:
            self.health.good('odom')

    def on_detections(self, message: Any) -> None:
        """Answer detections; nobody detected is an answer too."""
        try:
            self.pedestrians.publish(self.people(message))
        except ConversionError as error:
            self.health.bad('detections', f'ignored: {error}')
        else:
            self.health.good('detections')
            self.health.answer()

    def people(self, message: Any) -> AgentStates:
        """
        Return who is there.

        :raises ConversionError: detections that cannot be used.
        """
        points = detection_points(message, self.kind, self.locator.frame)
        stamp = self.moments.take(nanoseconds_of(message.header.stamp))
        self.rate.take(stamp * 1e-9)
        self.health.advise(self.rate.complaint(self.settings.coast_time))
        tracks = self.tracker.update(stamp * 1e-9, points)
        radius, frame = self.settings.pedestrian_radius, self.locator.planning_frame
        result = tracks_message(tracks, radius, stamp, frame)
        result.source = self.source
        return result

    def close(self) -> None:
        """Do nothing: pedestrians that age are the policy's matter."""


def tracker_settings(parameters: TrackerParameters) -> TrackerSettings:
    """Return what the filters and their assignment go by."""
    return TrackerSettings(
        acceleration_noise=parameters.acceleration_noise,
        detection_noise=parameters.detection_noise,
        start_speed=parameters.start_speed,
        gate=parameters.gate,
        coast_time=parameters.coast_time,
        confirmation_time=parameters.confirmation_time,
    )


def main() -> None:
    """Run the node."""
    sys.exit(run(TrackerNode))
