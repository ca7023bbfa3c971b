"""A robot for tests of the policy node: its inputs and its commands."""

import math

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry

from helpers.worlds import messages_of
from socialnav import qos
from socialnav_msgs.msg import AgentStates

KINDS = {
    'odom': (Odometry, qos.ODOMETRY),
    'pedestrians': (AgentStates, qos.PEDESTRIANS),
    'obstacles': (AgentStates, qos.OBSTACLES),
    'goal_pose': (PoseStamped, qos.GOAL),
}


def speed(twist):
    """Return the speed of a command."""
    return math.hypot(twist.linear.x, twist.linear.y)


def drives(graph, commands):
    """Wait until new commands make the robot move."""
    commands.clear()
    graph.wait(lambda: commands and speed(commands[-1]) > 0.1, 'motion')


class Robot:
    """Publishes inputs of the policy node."""

    def __init__(self, graph):
        self.graph = graph
        self.now = lambda: graph.node.get_clock().now().nanoseconds
        self.publishers = {
            name: graph.node.create_publisher(kind, name, profile)
            for name, (kind, profile) in KINDS.items()
        }

    def wait(self):
        """Wait until the policy node listens to everything."""
        self.graph.wait(
            lambda: all(one.get_subscription_count() for one in self.publishers.values()), 'node'
        )

    def publish(self, state, without=(), frame='odom', change=lambda messages: None, shift=0.0):
        """Publish a state as of now, or of some seconds later, with messages changed."""
        now = self.now() + int(shift * 1e9)
        messages = messages_of(state, now, frame)
        change(messages)
        for name, message in messages.items():
            if name not in without:
                self.publishers[name].publish(message)
