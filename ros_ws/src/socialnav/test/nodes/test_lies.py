"""Odometry and trackers that contradict themselves are named while an independent base drives."""

from diagnostic_msgs.msg import DiagnosticArray
from helpers import stops
from helpers.base import Build, turned
from helpers.course import Course
from helpers.faults import FAULTS
from helpers.graph import open_graph
from helpers.walkers import Walkers
import numpy as np
import pytest

from socialnav import qos
from socialnav.control.reasons import ARRIVED, DRIVING

HONEST = 5.0
"""Time of driving after which a fault that has ended is not told any more, s."""


class Liar:
    """A base on a course, whose odometry can be changed, and what its policy node says."""

    def __init__(self, graph):
        self.course = Course(graph, Walkers(1, 6.0, 5), 5)
        self.health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
        self.robot = self.course.add('liar', Build())
        self.robot.base.told.heading, self.turns = 2.0, 0

    def honest(self):
        """Let the robot tell the truth again, and drive."""
        self.robot.change, self.robot.repeats = (lambda odometry: odometry), True
        self.drive()
        self.course.until(lambda: False, HONEST)
        assert self.course.until(lambda: self.told() in (DRIVING, ARRIVED), 60.0), self.told()

    def drive(self):
        """Drive to another goal."""
        self.aim()
        assert self.course.until(lambda: np.hypot(*self.robot.base.velocity) > 0.5, 20.0)

    def aim(self):
        """Set another goal, far away, on a way that is no direction of the axes."""
        self.turns += 1
        self.course.send(self.robot, np.array([5.0, 4.0]) * (-1) ** self.turns)

    def told(self):
        """Return what diagnostics tell."""
        return self.health[-1].status[0].message if self.health else ''

    def says(self, name):
        """Drive back and forth until what the table of faults has is said."""
        for _ in range(4):
            if self.course.until(lambda: FAULTS[name].said in self.told(), 8.0):
                return
            self.aim()  # as well as it can by what it is told
        raise AssertionError(f'{FAULTS[name].said!r} is not told, but {self.told()!r}')


@pytest.fixture(scope='module')
def liar():
    """Yield a robot that all tests of this file drive in turn."""
    with open_graph() as graph:
        yield Liar(graph)


def test_a_twist_in_the_frame_of_the_pose_is_named(liar):
    liar.honest()

    def change(odometry):
        twist = odometry.twist.twist.linear
        twist.x, twist.y = map(float, turned((twist.x, twist.y), liar.robot.base.told.heading))
        return odometry

    liar.robot.change = change
    liar.says('twist of another frame')
    liar.honest()


def test_a_pose_that_stands_while_the_twist_moves_is_named(liar):
    liar.honest()
    place = liar.robot.base.told.place

    def change(odometry):
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = map(float, place)
        return odometry

    liar.robot.change = change
    liar.says('pose stands')


def test_a_robot_stands_after_its_pose_has_jumped_until_it_has_another_goal(liar):
    liar.honest()
    liar.drive()
    liar.course.until(lambda: False, 1.5)  # a jump beside a new goal is a new beginning
    liar.robot.repeats = False

    def change(odometry):
        odometry.pose.pose.position.y += 3.0
        return odometry

    liar.robot.change, began, fault = change, liar.course.now, FAULTS['odom jumps']
    assert liar.course.until(lambda: fault.said in liar.robot.state, 5.0), liar.robot.state
    stops.note(fault.what, liar.course.now - began, fault.within)
    liar.course.until(lambda: False, 2.0)
    assert fault.said in liar.robot.state and np.hypot(*liar.robot.base.velocity) < 1e-6
    liar.drive()


def test_a_person_who_jumps_is_named(liar):
    liar.honest()

    def jumps():
        liar.course.walkers.position[0] *= -1
        return liar.course.until(lambda: FAULTS['people jump'].said in liar.told(), 2.0)

    liar.course.walkers.position[0] = [6.0, -6.0]
    assert any(jumps() for _ in range(10)), liar.told()


def test_a_person_faster_than_anybody_runs_is_named(liar):
    liar.honest()
    tell = liar.robot.tell_people
    liar.robot.tell_people = lambda now, place, way, size: tell(now, place, way + 30.0, size)
    liar.says('people too fast')
    del liar.robot.tell_people
