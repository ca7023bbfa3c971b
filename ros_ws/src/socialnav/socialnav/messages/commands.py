"""Commands of the robot from messages."""

from geometry_msgs.msg import Twist
import numpy as np

from socialnav.messages.conversions import finite
from socialnav_core.simulation.kinematics import kinematics_of, Limits


def command_array(twist: Twist, kinematics: str) -> np.ndarray:
    """
    Return (vx, vy) in base_link or speed and turn rate, (2,).

    :param kinematics: holonomic or differential.
    """
    command = kinematics_of(kinematics).from_twist(twist.linear.x, twist.linear.y, twist.angular.z)
    return finite('cmd_vel', 'velocity', command.tolist())


def executed(command: np.ndarray, kinematics: str, limits: Limits) -> np.ndarray:
    """
    Return what a base makes of a command, (2,): the command itself where it can do that.

    :param command: (vx, vy) in base_link or speed and turn rate, (2,).
    :param kinematics: holonomic or differential.
    """
    return kinematics_of(kinematics).reachable(command, command, limits, limits.period)
