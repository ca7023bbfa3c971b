"""A robot that stands at the origin of odom and measures with lasers, for several nodes."""

from diagnostic_msgs.msg import DiagnosticArray
import numpy as np
from sensor_msgs.msg import LaserScan

from helpers.robot import KINDS
from helpers.worlds import messages_of, random_state
from socialnav import qos
from socialnav.demo.children import command_line
from socialnav.messages.sensor_messages import scan_message
from socialnav.messages.stamps import header_message
from socialnav_core.sensing import beam_angles, cast_rays
from socialnav_msgs.msg import AgentStates

BEAMS, REACH = 360, 10.0
AHEAD_OF_LASER = [(1.2, 0.0)], [0.5]
"""Positions and radii of what a laser sees."""


def resting_state(pedestrians=0):
    """Return a world with a robot that stands at the origin and wants to go along the x axis."""
    state = random_state(0, pedestrians=pedestrians, obstacles=0)
    state.robot.position[:], state.robot.velocity[:], state.robot.heading[:] = 0.0, 0.0, 0.0
    state.robot.goal[:] = [[5.0, 0.0]]
    return state


def scan_of(positions, radii, stamp, frame='laser', bounds=np.inf):
    """Return what a laser at the origin sees of discs."""
    places = np.reshape(positions, (-1, 2)).astype(float)
    ranges, _ = cast_rays(np.zeros(2), beam_angles(BEAMS), places, np.array(radii), bounds)
    ranges[ranges > REACH] = np.inf
    return scan_message(ranges, REACH, 0.05, stamp, frame)


class Measuring:
    """Publishes what the robot measures: odom, people and goal, and scans by their topics."""

    def __init__(self, graph, *scans, people=True):
        self.graph, self.state = graph, resting_state()
        create = graph.node.create_publisher
        names = ('odom', 'goal_pose', *(['pedestrians'] if people else []))
        self.publishers = {name: create(*KINDS[name][:1], name, KINDS[name][1]) for name in names}
        self.scans = {topic: create(LaserScan, topic, qos.SCAN) for topic in scans}
        self.changes = lambda message: message

    def header(self, frame):
        """Return a header as of now."""
        return header_message(self.now(), frame)

    def now(self):
        return self.graph.node.get_clock().now().nanoseconds

    def tell(self, **seen):
        """Publish all as of now; scans are given as positions and radii of discs by topic."""
        for name, message in messages_of(self.state, self.now()).items():
            if name in self.publishers:
                self.publishers[name].publish(message)
        for topic, discs in seen.items():
            scan = scan_of(*discs, self.now(), f'{topic}_laser')
            self.scans[topic].publish(self.changes(scan))

    def during(self, duration, **seen):
        """Publish 20 times a second for some time, s."""
        for _ in range(round(duration * 20)):
            self.tell(**seen)
            self.graph.spin(0.05)

    def until(self, condition, what, **seen):
        """Publish 20 times a second until a condition holds; return its value."""

        def holds():
            self.tell(**seen)
            self.graph.spin(0.05)
            return condition()

        return self.graph.wait(holds, what)


class Sensing:
    """An obstacle node with its scans, its lists and what it says."""

    def __init__(self, graph, **parameters):
        self.graph, self.robot = graph, Measuring(graph, 'scan')
        self.lists = graph.listen(AgentStates, 'obstacles', qos.OBSTACLES_INPUT)
        self.health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
        graph.start('obstacle_node', **parameters)

    def changed(self, **fields):
        """Change fields of all scans from now on."""

        def change(scan):
            for name, value in fields.items():
                setattr(scan, name, value)
            return scan

        self.robot.changes = change

    def answer(self, scan=AHEAD_OF_LASER):
        """Return the list that a scan of discs becomes."""
        self.robot.until(lambda: self.lists, 'list', scan=scan)
        self.robot.during(0.3, scan=scan)
        return self.lists[-1]

    def refuses(self, words):
        """Publish until the node says why it refuses the scans; return what it said."""

        def said():
            told = self.health[-1].status[0].message if self.health else ''
            return words in told and told

        return self.robot.until(said, f'{words!r}', scan=AHEAD_OF_LASER)


def start_obstacle_node(graph, scan, **parameters):
    """Start a node that listens to another topic than scan."""
    return graph.run(command_line('obstacle_node', parameters, {'scan': scan}))
