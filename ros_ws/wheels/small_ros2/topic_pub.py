"""`ros2 topic pub`: publish a message once or at a rate."""

import argparse
from itertools import count

from rclpy.duration import Duration
from rclpy.publisher import Publisher
from rclpy.task import Future

from small_ros2.command import CommandError
from small_ros2.filling import filled
from small_ros2.graph import comes, probe, spin
from small_ros2.messages import message_class

DEPTH = 10
"""Messages that are kept for a slow subscriber."""
PATIENCE = 10.0
"""Time to wait for a subscriber of the only message, s; ros2cli waits for ever."""
LAST_WORD = Duration(seconds=1)
"""How long it is waited at the end for the message to arrive."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument('topic_name', help='for instance /goal_pose')
    parser.add_argument('message_type', help='for instance geometry_msgs/msg/PoseStamped')
    parser.add_argument('values', nargs='?', default='{}', help='message as YAML')
    parser.add_argument('-1', '--once', action='store_true', help='publish one message, then end')
    parser.add_argument('-r', '--rate', type=rate, default=1.0, help='per second (default: 1)')
    parser.set_defaults(command=publish)


def rate(text: str) -> float:
    """
    Return how often to publish, Hz.

    :param text: as typed; argparse reports a ValueError.
    """
    if not 0.0 < float(text) < float('inf'):
        raise ValueError(text)
    return float(text)


def publish(options: argparse.Namespace) -> None:
    """Publish a message, again and again unless it is wanted once."""
    kind = message_class(options.message_type)
    filled(kind, options.values)  # what cannot be is refused before anything is published
    with probe() as node:
        publisher = node.create_publisher(kind, options.topic_name, DEPTH)
        numbers, done = count(1), Future()

        def on_timer() -> None:
            """Publish the message as of now."""
            message = filled(kind, options.values)
            print(f'publishing #{next(numbers)}: {message!r}\n')
            publisher.publish(message)
            if options.once:
                done.set_result(True)

        if options.once:
            wait_for_subscriber(publisher)
        print('publisher: beginning loop')
        node.create_timer(1.0 / options.rate, on_timer)
        spin(node, done)
        publisher.wait_for_all_acked(LAST_WORD)


def wait_for_subscriber(publisher: Publisher) -> None:
    """
    Wait until somebody listens.

    :raises CommandError: when nobody does.
    """
    if not publisher.get_subscription_count():
        print('Waiting for at least 1 matching subscription(s)...')
    if not comes(publisher.get_subscription_count, PATIENCE):
        raise CommandError(f'nobody listens to {publisher.topic_name}')
