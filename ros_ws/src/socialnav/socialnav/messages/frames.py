"""Where one frame lies in another, and who may be asked for it."""

from collections.abc import Callable

from socialnav_core.sensing import Pose

Locate = Callable[[str, str, int], Pose]
"""
Says where a frame (second) lies in another (first) at a time (third, ns; 0 for the newest known).

Raises LookupError, whose text says what is missing.
"""


def not_asked(frame: str, source: str, stamp: int) -> Pose:
    """
    Refuse, where all inputs must be in one frame.

    :param frame: the frame that is wanted.
    :param source: the frame that an input is in.
    :param stamp: time of the input, ns.
    """
    raise LookupError(f'everything must be in {frame!r}')
