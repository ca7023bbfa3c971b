"""The robot, its goal and its commands."""

import numpy as np

from socialnav_core.messages.parts import header, Message, rotation, vector
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.simulation.kinematics.angles import rotated
from socialnav_core.states import CrowdState


def odometry(state: CrowdState, nanoseconds: int, frame: str, base_frame: str) -> Message:
    """
    Return pose and velocity of the robot as a nav_msgs/Odometry.

    :param state: batch of one.
    :param frame: frame of the state and of the pose.
    :param base_frame: frame of the twist, fixed to the robot.
    """
    heading = float(state.robot.heading[0])
    pose = {'position': vector(state.robot.position[0]), 'orientation': rotation(heading)}
    linear = vector(rotated(state.robot.velocity[0], -heading))
    twist = {'linear': linear, 'angular': vector(np.zeros(2), float(state.robot.turn_rate[0]))}
    return {
        'header': header(nanoseconds, frame),
        'child_frame_id': base_frame,
        'pose': {'pose': pose},
        'twist': {'twist': twist},
    }


def goal(state: CrowdState, nanoseconds: int, frame: str) -> Message:
    """
    Return the robot's goal as a geometry_msgs/PoseStamped; its orientation means nothing.

    :param state: batch of one.
    """
    pose = {'position': vector(state.robot.goal[0]), 'orientation': rotation(0.0)}
    return {'header': header(nanoseconds, frame), 'pose': pose}


def twist(command: np.ndarray, kinematics: str) -> Message:
    """
    Return a command of the robot as a geometry_msgs/Twist.

    :param command: (vx, vy) in the robot's own frame, m/s, or speed and turn rate, (2,).
    :param kinematics: holonomic or differential.
    """
    forward, left, turn_rate = kinematics_of(kinematics).twist(command)
    return {'linear': {'x': forward, 'y': left}, 'angular': {'z': turn_rate}}


def stamped_twist(twist: Message, nanoseconds: int, base_frame: str) -> Message:
    """
    Return a command with its time as a geometry_msgs/TwistStamped.

    :param nanoseconds: its time, in lockstep that of the state that it answers.
    """
    return {'header': header(nanoseconds, base_frame), 'twist': twist}
