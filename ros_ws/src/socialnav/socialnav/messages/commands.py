"""Commands of the robot as messages."""

from geometry_msgs.msg import Twist, TwistStamped, Vector3
import numpy as np

from socialnav.messages.conversions import finite
from socialnav.messages.stamps import header_message
from socialnav_core.simulation.kinematics import kinematics_of


def twist_message(command: np.ndarray, kinematics: str) -> Twist:
    """
    Return a command of the robot.

    :param command: (vx, vy) in base_link or speed and turn rate, (2,).
    :param kinematics: holonomic or differential.
    """
    forward, left, turn_rate = kinematics_of(kinematics).twist(command)
    return Twist(linear=Vector3(x=forward, y=left), angular=Vector3(z=turn_rate))


def stamped_twist_message(twist: Twist, nanoseconds: int, base_frame: str) -> TwistStamped:
    """
    Return a command with its time.

    :param twist: the command.
    :param nanoseconds: its time, in lockstep that of the state that it answers.
    :param base_frame: frame of the robot.
    """
    return TwistStamped(header=header_message(nanoseconds, base_frame), twist=twist)


def command_array(twist: Twist, kinematics: str) -> np.ndarray:
    """
    Return (vx, vy) in base_link or speed and turn rate, (2,).

    :param twist: a command of the robot.
    :param kinematics: holonomic or differential.
    """
    command = kinematics_of(kinematics).from_twist(twist.linear.x, twist.linear.y, twist.angular.z)
    return finite('cmd_vel', 'velocity', command.tolist())
