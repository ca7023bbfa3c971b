"""The node that turns detections of people into pedestrians with names and velocities."""

import sys
from typing import Any

from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.parameter import Parameter

from socialnav import qos
from socialnav.messages.conversions import ConversionError
from socialnav.messages.detection_types import DETECTION_TYPES, message_class
from socialnav.messages.sensor_messages import detection_points, tracks_message
from socialnav.messages.sources import new_source
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters.declaring import declare, updated
from socialnav.parameters.tracker import TrackerParameters
from socialnav.perception.locating import Locator
from socialnav.running import run
from socialnav_core.sensing import Tracker, TrackerSettings
from socialnav_msgs.msg import AgentStates

ACCEPTED_DELAY = 0.2
"""Age relative to the newest detections up to which others count as seen with them, s."""
CLOCK_STEP = 1.0
"""Age relative to the newest detections from which it is the clock that went back, s."""


class TrackerNode(Node):
    """Answers each message of detections with all confirmed tracks."""

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
        self.newest = 0
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
            self.refuse(error)

    def on_detections(self, message: Any) -> None:
        """Answer detections; nobody detected is an answer too."""
        try:
            points = detection_points(message, self.kind, self.locator.frame)
        except ConversionError as error:
            self.refuse(error)
            return
        stamp = self.moment_of(nanoseconds_of(message.header.stamp))
        if stamp is None:
            return
        tracks = self.tracker.update(stamp * 1e-9, points)
        radius, frame = self.settings.pedestrian_radius, self.locator.planning_frame
        message = tracks_message(tracks, radius, stamp, frame)
        message.source = self.source
        self.pedestrians.publish(message)

    def moment_of(self, stamp: int) -> int | None:
        """
        Return the time for which detections count, ns; None where they come too late.

        Of several detectors one is slower than another: what it saw shortly before the newest
        detections counts as seen with them. A larger step back is a clock that was set.

        :param stamp: of the detections, ns.
        """
        late = (self.newest - stamp) * 1e-9
        if ACCEPTED_DELAY < late <= CLOCK_STEP:
            self.refuse(f'detections {late:.2f} s older than the newest')
            return None
        if 0 < late <= ACCEPTED_DELAY:
            return self.newest
        self.newest = stamp
        return stamp

    def refuse(self, error: ConversionError | str) -> None:
        """Say why a message cannot be used."""
        self.get_logger().warning(f'ignored: {error}', throttle_duration_sec=1.0)

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
        hits=parameters.hits,
    )


def main() -> None:
    """Run the node."""
    sys.exit(run(TrackerNode))
