"""Times in nanoseconds, as integers, so that equal stamps are equal."""

from builtin_interfaces.msg import Time
from std_msgs.msg import Header


def time_message(nanoseconds: int) -> Time:
    """
    Return a time as a message.

    :param nanoseconds: since the epoch of the clock.
    """
    return Time(sec=nanoseconds // 10**9, nanosec=nanoseconds % 10**9)


def nanoseconds_of(stamp: Time) -> int:
    """
    Return a stamp in nanoseconds, exactly.

    :param stamp: the time of a header.
    """
    return stamp.sec * 10**9 + stamp.nanosec


def header_message(nanoseconds: int, frame: str) -> Header:
    """
    Return a header.

    :param nanoseconds: its time.
    :param frame: its frame.
    """
    return Header(stamp=time_message(nanoseconds), frame_id=frame)
