"""Laws of the obstacle node, over the middleware."""

import signal

from helpers.worlds import messages_of, random_state
from nav_msgs.msg import OccupancyGrid, Odometry
import numpy as np
import pytest
from sensor_msgs.msg import LaserScan

from socialnav import qos
from socialnav.messages.occupancy import map_message
from socialnav.messages.sensor_messages import scan_message
from socialnav_core.sensing import DetectorSettings, ScannerSettings, Sensors
from socialnav_msgs.msg import AgentStates


class Robot:
    """Publishes what a robot measures, and collects obstacles."""

    def __init__(self, graph, **parameters):
        self.graph = graph
        self.state = random_state(0, pedestrians=0, obstacles=1)
        self.state.agents.position[:] = self.state.robot.position + [[[2.0, 1.0]]]
        create = graph.node.create_publisher
        self.odometry = create(Odometry, 'odom', qos.ODOMETRY)
        grid = parameters.get('source') == 'grid'
        kind = (OccupancyGrid, 'map', qos.MAP) if grid else (LaserScan, 'scan', qos.SCAN)
        self.surfaces = create(*kind)
        self.obstacles = graph.listen(AgentStates, 'obstacles', qos.OBSTACLES)
        self.process = graph.start('obstacle_node', **parameters)
        publishers = self.odometry, self.surfaces
        graph.wait(lambda: all(one.get_subscription_count() for one in publishers), 'node')

    def measure(self):
        """Publish what is measured now."""
        self.tell_place()
        ranges = Sensors(ScannerSettings(), DetectorSettings(), 0, 0).scan(self.state)
        self.surfaces.publish(scan_message(ranges, 10.0, 0.05, self.now(), 'laser'))

    def tell_place(self):
        """Publish where the robot is now."""
        self.odometry.publish(messages_of(self.state, self.now())['odom'])

    def now(self):
        return self.graph.node.get_clock().now().nanoseconds

    def answered(self, publish):
        """Publish until there are obstacles; return them."""

        def answer():
            publish()
            self.graph.spin(0.05)
            return self.obstacles

        return self.graph.wait(answer, 'obstacles')[-1]

    def clearance(self, message):
        """Return how near the nearest disc is to the centre of the robot."""
        centres = np.array([(one.position.x, one.position.y) for one in message.agents])
        distance = np.linalg.norm(centres - self.state.robot.position[0], axis=1)
        return (distance - [one.radius for one in message.agents]).min()


def test_a_scan_becomes_discs_with_the_clearance_of_the_obstacle(graph):
    robot = Robot(graph, bounds=7.0)
    robot.state.robot.velocity[:] = 0.0
    message = robot.answered(robot.measure)
    expected = np.hypot(2.0, 1.0) - robot.state.agents.radius[0, 0]
    assert robot.clearance(message) == pytest.approx(expected, abs=0.01)
    assert message.header.frame_id == 'odom'


def test_without_odom_or_without_scans_there_are_no_obstacles(graph):
    robot = Robot(graph)
    ranges = np.ones(36)
    for _ in range(10):
        robot.surfaces.publish(scan_message(ranges, 10.0, 0.05, robot.now(), 'laser'))
        graph.spin(0.05)
    assert robot.obstacles == []
    robot.answered(robot.measure)
    graph.spin(0.3)
    robot.obstacles.clear()
    for _ in range(10):
        robot.tell_place()
        graph.spin(0.05)
    assert robot.obstacles == []


def test_a_grid_becomes_discs_whenever_the_robot_is_somewhere_else(graph):
    robot = Robot(graph, source='grid', grid_frame='map', bounds=7.0)
    robot.surfaces.publish(map_message(robot.state, robot.now(), 'map'))
    clearance = robot.clearance(robot.answered(robot.tell_place))
    expected = np.hypot(2.0, 1.0) - robot.state.agents.radius[0, 0]
    assert expected - 0.15 < clearance < expected + 0.05


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_obstacle_node_with_exit_code_0(graph, number):
    process = Robot(graph).process
    graph.kill(process, number)
    graph.wait(lambda: process.poll() is not None, 'end of the process')
    assert process.returncode == 0
