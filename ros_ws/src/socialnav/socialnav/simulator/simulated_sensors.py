"""The sensors of the simulated robot as topics."""

from geometry_msgs.msg import PoseArray
from rclpy.node import Node
from sensor_msgs.msg import LaserScan

from socialnav import qos
from socialnav.messages.sensor_messages import detections_message, scan_message
from socialnav.parameters.simulator import SimulatorParameters
from socialnav.simulator.settings import detector_of, frames_of, scanner_of
from socialnav.simulator.world import World
from socialnav_core.sensing import Sensors


class SimulatedSensors:
    """Publishes what is wanted of scan and detections."""

    def __init__(self, node: Node, parameters: SimulatorParameters) -> None:
        """Make the publishers."""
        self.frames = frames_of(parameters)
        self.scan_time = parameters.publish_period
        self.scanner, self.detector = scanner_of(parameters), detector_of(parameters)
        self.scans = self.detections = None
        if parameters.publish_scan:
            self.scans = node.create_publisher(LaserScan, 'scan', qos.SCAN)
        if parameters.publish_detections:
            self.detections = node.create_publisher(PoseArray, 'detections', qos.DETECTIONS)

    def publish(self, world: World, stamp: int) -> None:
        """
        Measure and publish; every episode has random numbers of its own.

        :param stamp: time of its state, ns.
        """
        if world.fresh:
            self.sensors = Sensors(self.scanner, self.detector, world.seed, world.case_index)
        if self.scans is not None:
            ranges = self.sensors.scan(world.state)
            self.scans.publish(
                scan_message(ranges, self.scanner.range, self.scan_time, stamp, self.frames.base)
            )
        if self.detections is not None:
            positions = self.sensors.detect(world.state)
            self.detections.publish(detections_message(positions, stamp, self.frames.odom))
