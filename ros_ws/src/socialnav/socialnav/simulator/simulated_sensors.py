"""The sensors of the simulated robot as topics."""

from typing import Any

from geometry_msgs.msg import PoseArray
from rclpy.node import Node
from sensor_msgs.msg import LaserScan

from socialnav import qos
from socialnav.messages.sensor_messages import detections_message, scan_message
from socialnav.simulator.world import World
from socialnav.simulator.world_messages import Frames
from socialnav_core.sensing import DetectorSettings, ScannerSettings, Sensors


class SimulatedSensors:
    """Publishes what is wanted of scan and detections."""

    def __init__(self, node: Node, values: dict[str, Any], frames: Frames) -> None:
        """
        Make the publishers.

        :param node: whose topics they are.
        :param values: all parameters of the simulator node.
        :param frames: names of the frames.
        """
        self.frames = frames
        self.scan_time = 1 / values['publish_rate']
        self.scanner = ScannerSettings(
            values['scan_beams'], values['scan_range'], values['scan_noise']
        )
        self.detector = DetectorSettings(
            values['detection_noise'], values['missed_detections'], values['detection_occlusion']
        )
        self.scans = self.detections = None
        if values['publish_scan']:
            self.scans = node.create_publisher(LaserScan, 'scan', qos.SCAN)
        if values['publish_detections']:
            self.detections = node.create_publisher(PoseArray, 'detections', qos.DETECTIONS)

    def publish(self, world: World, stamp: int) -> None:
        """
        Measure and publish; every episode has random numbers of its own.

        :param world: as it is.
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
