"""Which clock makes a node act."""

from rclpy.clock import Clock, ClockType
from rclpy.node import Node


def pacing_clock(node: Node) -> Clock:
    """
    Return the clock for timers: simulated time where the node has it, else one that nobody sets.

    The system's clock may be set back, and whoever waits on it then waits for as long as that.

    :param node: whose timers they are.
    """
    clock = node.get_clock()
    return clock if clock.ros_time_is_active else Clock(clock_type=ClockType.STEADY_TIME)
