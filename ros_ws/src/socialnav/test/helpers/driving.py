"""A policy node that drives as a test wants it to."""

import time

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist

from helpers import stops
from helpers.faults import FAULTS
from helpers.robot import Robot, speed
from helpers.worlds import random_state
from socialnav import qos


class Drive:
    """A policy node with its inputs, as real processes."""

    def __init__(self, graph):
        self.graph, self.robot = graph, Robot(graph)
        self.commands, self.stopped = [], None
        graph.node.create_subscription(Twist, 'cmd_vel', self.on_command, qos.COMMAND)
        self.health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)

    def on_command(self, command):
        """Keep a command, and since when the robot has been told to stand."""
        self.commands.append(command)
        if speed(command):
            self.stopped = None
        elif self.stopped is None:
            self.stopped = time.monotonic()

    def start(self, command=None, **parameters):
        """Start a policy node, or a program that is like one."""
        if command is None:
            self.graph.start('policy_node', **({'model': 'orca'} | parameters))
        else:
            self.graph.run(command)
        self.robot.wait()
        return self

    def until(self, moving, reason, state, what, **options):
        """Publish a state until the robot moves, or stands for a reason, for three commands."""

        def as_wanted():
            self.robot.publish(state, **options)
            self.graph.spin(0.05)
            told = self.health[-1].status[0].message if self.health else ''
            latest = [speed(one) for one in self.commands[-3:]]
            return (
                len(latest) == 3 and reason in told and all((one > 0) == moving for one in latest)
            )

        self.commands.clear()
        self.graph.wait(as_wanted, f'{"motion" if moving else "stop"}: {what}')

    def moves(self, state, what='all is well', **options):
        """Wait until the robot moves."""
        self.until(True, 'driving', state, what, **options)

    def stands(self, reason, state, what, within=stops.LIMIT, **options):
        """Wait until the robot stands for a reason; it must be told so soon enough."""
        began, self.stopped = time.monotonic(), None
        self.until(False, reason, state, what, **options)
        stops.note(what, self.stopped - began, within)

    def shows(self, name, state, **options):
        """Wait until the robot stands as the table of faults says; it must be soon enough."""
        fault = FAULTS[name]
        self.stands(fault.said, state, fault.what, fault.within, **options)

    def says(self, name, state, **options):
        """Wait until what the table of faults has is said of a robot that drives."""

        def told():
            self.robot.publish(state, **options)
            self.graph.spin(0.05)
            return self.health and FAULTS[name].said in self.health[-1].status[0].message

        self.graph.wait(told, FAULTS[name].said)


def drives_among_any_number(drive):
    """Show a robot nobody, somebody twice, and very many."""
    drive.moves(random_state(0, pedestrians=0, obstacles=0), 'nobody at all')
    drive.moves(random_state(0), 'one id for all', change=duplicate)
    crowd = random_state(0, pedestrians=500)
    crowd = crowd.with_agents(position=crowd.agents.position + 40.0)
    drive.moves(crowd, '500 pedestrians')


def duplicate(messages):
    """Give all pedestrians one id."""
    for one in messages['pedestrians'].agents:
        one.id = 7
