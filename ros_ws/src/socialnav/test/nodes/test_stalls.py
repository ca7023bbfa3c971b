"""A decision or a clock that does not go on must not leave the robot to itself."""

from pathlib import Path
import sys
import time

from helpers.driving import Drive
from helpers.robot import speed
from helpers.worlds import random_state
import numpy as np
import pytest
from rosgraph_msgs.msg import Clock

from socialnav import qos
from socialnav.messages.stamps import time_message

pytestmark = pytest.mark.usefixtures('repetition')

STALLING_NODE = Path(__file__).parents[1] / 'helpers' / 'stalling_node.py'


class SimulatedTime:
    """Time that is published, and can stand and jump."""

    def __init__(self, graph, publisher):
        self.running, self.offset = True, 1000.0 - time.monotonic()
        self.publisher, self.latest = publisher, 0
        graph.node.create_timer(0.02, self.publish)

    def publish(self):
        """Tell the time, if it runs."""
        if self.running:
            self.latest = int((time.monotonic() + self.offset) * 1e9)
            self.publisher.publish(Clock(clock=time_message(self.latest)))

    def read(self):
        """Return the time, ns."""
        return self.latest


def test_a_decision_that_stalls_stops_the_robot_while_it_lasts(graph):
    drive = Drive(graph).start([sys.executable, str(STALLING_NODE)])
    state = random_state(0)
    state.robot.position[:] = 0.0
    drive.moves(state)
    beyond = state.with_robot(position=np.array([[2.0, 0.0]]))
    drive.shows('decision hangs', beyond)
    drive.moves(state)


def test_a_clock_that_stands_or_jumps_back_stops_the_robot_until_it_goes_on(graph):
    drive = Drive(graph)
    clock = graph.node.create_publisher(Clock, '/clock', qos.CLOCK)
    simulated = SimulatedTime(graph, clock)
    drive.robot.now = simulated.read
    drive.start(use_sim_time=True)
    state = random_state(0)
    drive.moves(state)
    simulated.running = False
    drive.shows('clock stopped', state)
    simulated.running = True
    drive.moves(state, 'the clock goes on')
    simulated.offset -= 100.0
    drive.moves(state, 'the clock has jumped back, and the stamps with it')


@pytest.mark.parametrize('simulated', [False, True])
def test_an_input_that_stops_stops_the_robot_at_its_time_out_and_not_at_the_next_tick(
    graph, simulated
):
    drive, state = Drive(graph), random_state(0)
    if simulated:
        clock = graph.node.create_publisher(Clock, '/clock', qos.CLOCK)
        drive.robot.now = SimulatedTime(graph, clock).read
    drive.start(controller_frequency=1.0, input_timeout=0.4, use_sim_time=simulated)
    drive.moves(state)
    drive.commands.clear()

    def commanded():
        drive.robot.publish(state)
        graph.spin(0.05)
        return drive.commands

    graph.wait(commanded, 'command of a tick')
    graph.wait(lambda: not speed(drive.commands[-1]), 'stop before the next tick', deadline=0.8)
