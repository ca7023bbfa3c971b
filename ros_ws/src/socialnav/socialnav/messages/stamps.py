"""Times in nanoseconds, as integers, so that equal stamps are equal."""

from builtin_interfaces.msg import Time
from std_msgs.msg import Header

from socialnav.messages.filling import filled
from socialnav_core.messages.parts import header, time


def time_message(nanoseconds: int) -> Time:
    """Return nanoseconds since the epoch of a clock as a message."""
    return filled(Time, time(nanoseconds))


def nanoseconds_of(stamp: Time) -> int:
    """Return a stamp in nanoseconds, exactly."""
    return stamp.sec * 10**9 + stamp.nanosec


def header_message(nanoseconds: int, frame: str) -> Header:
    """Return a header."""
    return filled(Header, header(nanoseconds, frame))
