"""`ros2 topic echo`: print the messages of a topic."""

import argparse
from functools import reduce
from typing import Any

from rclpy.task import Future

from small_ros2.command import CommandError
from small_ros2.graph import probe, spin
from small_ros2.messages import message_text
from small_ros2.subscription import find

LONGEST = 128
"""Elements of arrays and characters of strings that are shown."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument('topic_name', help='for instance /odom')
    parser.add_argument('message_type', nargs='?', help='where nobody publishes it yet')
    parser.add_argument('--once', action='store_true', help='print the first message, then end')
    parser.add_argument('--field', help='print only this, for instance pose.pose.position')
    parser.add_argument('-f', '--full-length', action='store_true', help='do not cut long arrays')
    parser.set_defaults(command=echo)


def echo(options: argparse.Namespace) -> None:
    """Print messages as they arrive."""
    with probe() as node:
        topic = node.resolve_topic_name(options.topic_name)
        kind, profile = find(node, topic, options.message_type)
        done = Future()

        def on_message(message: Any) -> None:
            """Print a message, unless the one that was wanted has been printed."""
            if not done.done():
                print(text(message, options), end='---\n')
            if options.once:
                done.set_result(True)

        node.create_subscription(kind, topic, on_message, profile)
        spin(node, done)


def text(message: Any, options: argparse.Namespace) -> str:
    """
    Return a message, or the wanted field of it, as text.

    :raises CommandError: when it has no such field.
    """
    try:
        part = reduce(getattr, options.field.split('.') if options.field else [], message)
    except AttributeError as error:
        raise CommandError(f"Invalid field '{options.field}': {error}") from error
    if hasattr(part, 'get_fields_and_field_types'):
        return message_text(part, None if options.full_length else LONGEST)
    return f'{part}\n'
