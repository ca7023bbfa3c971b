"""Which clock makes a node act."""

from rclpy.clock import Clock, ClockType, ROSClock
from rclpy.node import Node


def pacing_clock(node: Node) -> Clock:
    """
    Return the clock for timers: simulated time where the node has it, else one that nobody sets.

    The system's clock may be set back, and whoever waits on it then waits for as long as that.
    """
    clock = node.get_clock()
    simulated = isinstance(clock, ROSClock) and clock.ros_time_is_active
    return clock if simulated else Clock(clock_type=ClockType.STEADY_TIME)
