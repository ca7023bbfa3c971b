"""Commands of the robot from messages."""

from geometry_msgs.msg import Twist
import numpy as np

from socialnav.messages.conversions import finite


def command_array(twist: Twist, kinematics: str) -> np.ndarray:
    """
    Return (vx, vy) in base_link or speed and turn rate, (2,).

    :param twist: a command of the robot.
    :param kinematics: holonomic or differential.
    """
    second = twist.angular.z if kinematics == 'differential' else twist.linear.y
    return finite('cmd_vel', 'velocity', [twist.linear.x, second])
