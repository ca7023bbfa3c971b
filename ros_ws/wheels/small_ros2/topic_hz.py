"""`ros2 topic hz`: measure how often messages arrive."""

import argparse
from collections import deque
from collections.abc import Sequence
from statistics import fmean, pstdev
import time

from rclpy.task import Future

from small_ros2.graph import probe, spin
from small_ros2.subscription import find

WINDOW = 10000
"""Messages that a rate is the mean of, unless told."""
PERIOD = 1.0
"""Time between two lines, s."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument('topic_name', help='for instance /odom')
    parser.add_argument('-w', '--window', type=window, default=WINDOW, help='messages to average')
    parser.set_defaults(command=measure)


def window(text: str) -> int:
    """
    Return the number of messages to average.

    :param text: as typed; argparse reports a ValueError.
    """
    if int(text) < 2:
        raise ValueError(text)
    return int(text)


def measure(options: argparse.Namespace) -> None:
    """Print the rate once a second, as long as messages arrive."""
    with probe() as node:
        topic = node.resolve_topic_name(options.topic_name)
        kind, profile = find(node, topic)
        arrivals: deque[float] = deque(maxlen=options.window)
        printed = [0.0]  # arrival that the last line ended with

        def on_timer() -> None:
            """Print the rate when a message has arrived since the last time."""
            if len(arrivals) > 1 and arrivals[-1] != printed[0]:
                printed[0] = arrivals[-1]
                print(rate_text(arrivals))

        node.create_subscription(
            kind, topic, lambda _: arrivals.append(time.monotonic()), profile, raw=True
        )
        node.create_timer(PERIOD, on_timer)
        spin(node, Future())


def rate_text(arrivals: Sequence[float]) -> str:
    """
    Return the rate and the spread of the intervals between messages.

    :param arrivals: times of at least two messages, s.
    """
    times = list(arrivals)
    intervals = [later - earlier for earlier, later in zip(times, times[1:], strict=False)]
    return (
        f'average rate: {1.0 / fmean(intervals):.3f}\n'
        f'\tmin: {min(intervals):.3f}s max: {max(intervals):.3f}s '
        f'std dev: {pstdev(intervals):.5f}s window: {len(times)}'
    )
