"""Somebody who has paths followed, as bt_navigator does, and a base that does what it is told."""

import math
from types import SimpleNamespace

from action_msgs.msg import GoalStatus, GoalStatusArray
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Path
import numpy as np
from rclpy.action import ActionClient
from rclpy.qos import qos_profile_action_status_default

from helpers.faults import FAULTS
from helpers.robot import Robot, speed
from helpers.worlds import quaternion_of, random_state
from socialnav import qos
from socialnav.control.following import Code
from socialnav.messages.stamps import header_message

STEP = 0.02
"""Time between two states of the base, s."""
ACTIVE = (GoalStatus.STATUS_ACCEPTED, GoalStatus.STATUS_EXECUTING, GoalStatus.STATUS_CANCELING)


class Base:
    """A holonomic base among nobody; it follows each command at once."""

    def __init__(self, graph):
        self.graph, self.robot = graph, Robot(graph)
        self.state = random_state(0, pedestrians=0, obstacles=0)
        self.state.robot.position[:], self.state.robot.heading[:] = 0.0, 0.0
        self.command, self.commands = Twist(), []
        self.held, self.without, self.change = False, ('goal_pose',), lambda messages: None
        graph.node.create_subscription(Twist, 'cmd_vel', self.on_command, qos.COMMAND)
        graph.node.create_timer(STEP, self.move)

    def on_command(self, command):
        """Follow a command from now on."""
        self.command = command
        self.commands.append(command)

    def move(self):
        """Move for a step, and tell where that led to."""
        robot, command = self.state.robot, self.command
        forward, left, turn = command.linear.x, command.linear.y, command.angular.z
        if self.held:
            forward = left = turn = 0.0
        cosine, sine = math.cos(robot.heading[0]), math.sin(robot.heading[0])
        velocity = np.array([cosine * forward - sine * left, sine * forward + cosine * left])
        robot.velocity[0], robot.turn_rate[:] = velocity, turn
        robot.position[0] += velocity * STEP
        robot.heading += turn * STEP
        self.robot.publish(self.state, without=self.without, change=self.change)

    def stands(self):
        """Return whether the robot was told to stand, by the last command."""
        return bool(self.commands) and not speed(self.command) and not self.command.angular.z


class PathClient:
    """Sends paths and keeps what is answered."""

    def __init__(self, graph, name='follow_path'):
        from nav2_msgs.action import FollowPath

        self.graph, self.action = graph, FollowPath
        self.client = ActionClient(graph.node, FollowPath, name)
        self.states = []
        graph.node.create_subscription(
            GoalStatusArray, f'{name}/_action/status', self.states.append,
            qos_profile_action_status_default,
        )  # fmt: skip

    def wait(self):
        """Wait until somebody offers the action."""
        self.graph.wait(self.client.server_is_ready, 'action server')

    def send(self, points, yaw=0.0, frame='odom', **names):
        """
        Have a path followed; return what is known of that, feedback and result.

        :param points: its places, m, (poses, 2).
        :param names: ids of controller and checkers.
        """
        return self.send_path(path_of(points, yaw, frame), **names)

    def send_path(self, path, **names):
        """Have a path followed that is a message."""
        goal = self.action.Goal(path=path, **names)
        known = SimpleNamespace(feedback=[], handle=None, result=None)
        future = self.client.send_goal_async(goal, lambda one: known.feedback.append(one.feedback))
        self.graph.wait(future.done, 'answer to a path')
        known.handle = future.result()
        if known.handle.accepted:
            known.result = known.handle.get_result_async()
        return known

    def outcome(self, known):
        """Return status, code and reason of a path once it has ended."""
        self.graph.wait(known.result.done, 'outcome of a path', deadline=20.0)
        answer = known.result.result()
        return answer.status, answer.result.error_code, answer.result.error_msg

    def cancel(self, known):
        """Cancel a path; return whether that was accepted."""
        future = known.handle.cancel_goal_async()
        self.graph.wait(future.done, 'answer to a cancellation')
        return bool(future.result().goals_canceling)

    def ends(self, known, name):
        """Wait until a path has ended as the table of faults says."""
        _, code, text = self.outcome(known)
        told, wanted = f'{Code(code).name}: {text}', FAULTS[name].said
        assert wanted in told, f'{told}, not {wanted}'

    def active(self):
        """Return how many paths are not at their end, as the server publishes it."""
        if not self.states:
            return 0
        return sum(one.status in ACTIVE for one in self.states[-1].status_list)


def path_of(points, yaw=0.0, frame='odom'):
    """Return a path whose last pose has a heading, rad."""
    path = Path(header=header_message(0, frame))
    for x, y in points:
        pose = PoseStamped(header=header_message(0, frame))
        pose.pose.position.x, pose.pose.position.y = float(x), float(y)
        pose.pose.orientation = quaternion_of(yaw)
        path.poses.append(pose)
    return path


def line(start, end, poses=20):
    """Return the places of a straight path, m, (poses, 2)."""
    return np.linspace(start, end, poses)
