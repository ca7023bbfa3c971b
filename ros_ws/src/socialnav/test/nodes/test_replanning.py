"""Laws of the policy under somebody who plans anew every second, among a simulated crowd."""

import time

from geometry_msgs.msg import PoseStamped, Twist
from helpers.nav2_interfaces import nav2_interfaces
from helpers.path_client import line, PathClient
from helpers.robot import speed
from nav_msgs.msg import Odometry
import pytest

from socialnav import qos

SUCCEEDED, ABORTED = 4, 6
LONGEST = 120.0
"""Time in which the robot arrives, s."""
TOLERANCE = 0.5
"""More than the simulator's, which would begin another episode at the goal, m."""


def place(pose):
    """Return where a pose is, m."""
    return pose.position.x, pose.position.y


@pytest.mark.slow
def test_a_differential_base_crosses_a_crowd_along_paths_that_come_every_second(graph):
    with nav2_interfaces():
        odometry, goals = graph.listen(Odometry, 'odom'), graph.listen(PoseStamped, 'goal_pose')
        commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
        graph.start(
            'policy_node', kinematics='differential', goal_topics=False, bounds=7.5,
            goal_tolerance=TOLERANCE, goal_yaw_tolerance=0.25, failure_tolerance=2.0,
        )  # fmt: skip
        client = PathClient(graph)
        client.wait()  # the episode is over soon, whether somebody drives or not
        graph.start('simulator_node', kinematics='differential', robot_visible=True, episodes=1)
        graph.wait(lambda: odometry and goals, 'world')
        goal = place(goals[0].pose)
        paths, end = [], time.monotonic() + LONGEST
        while not (paths and paths[-1].result.done()):
            assert time.monotonic() < end, 'the robot does not arrive'
            start = place(odometry[-1].pose.pose)
            paths.append(client.send(line(start, goal, 200), yaw=1.0))
            second = time.monotonic() + 1.0
            while time.monotonic() < second and not paths[-1].result.done():
                graph.spin(0.05)
        outcomes = [client.outcome(one) for one in paths]
        assert outcomes[-1] == (SUCCEEDED, 0, '') and len(outcomes) > 3
        assert {one[:2] for one in outcomes[:-1]} == {(ABORTED, 0)}
        graph.wait(lambda: not speed(commands[-1]) and not commands[-1].angular.z, 'stop')
