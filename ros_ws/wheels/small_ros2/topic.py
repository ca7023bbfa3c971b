"""`ros2 topic`: the topics of the graph."""

import argparse

from rclpy.node import Node

from small_ros2 import topic_echo, topic_hz, topic_pub
from small_ros2.command import CommandError
from small_ros2.graph import look, node_names, probe, visible


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the group."""
    verbs = parser.add_subparsers(metavar='VERB', required=True)
    verb = verbs.add_parser('list', help='print the names of the topics')
    verb.add_argument('-t', '--show-types', action='store_true', help='with their types')
    verb.set_defaults(command=list_topics)
    verb = verbs.add_parser('info', help='print the type of a topic and how many use it')
    verb.add_argument('topic_name', help='for instance /odom')
    verb.add_argument(
        '-v', '--verbose', action='store_true', help='with each endpoint and its QoS'
    )
    verb.set_defaults(command=info)
    topic_echo.add_arguments(verbs.add_parser('echo', help='print the messages of a topic'))
    topic_hz.add_arguments(verbs.add_parser('hz', help='print how often messages arrive'))
    topic_pub.add_arguments(verbs.add_parser('pub', help='publish messages'))


def list_topics(options: argparse.Namespace) -> None:
    """Print the names of the topics."""
    with probe() as node:
        look(node, lambda: node_names(node))
        for name, types in visible(node.get_topic_names_and_types()):
            print(f'{name} [{", ".join(types)}]' if options.show_types else name)


def info(options: argparse.Namespace) -> None:
    """Print the type of a topic and its endpoints."""
    with probe() as node:
        topic = node.resolve_topic_name(options.topic_name)
        if not look(node, lambda: types_of(node, topic)):
            raise CommandError(f"Unknown topic '{options.topic_name}'")
        end = '\n\n' if options.verbose else '\n'
        types = types_of(node, topic)
        print(f'Type: {types[0] if len(types) == 1 else types}', end=end)
        publishers = node.get_publishers_info_by_topic(topic)
        subscriptions = node.get_subscriptions_info_by_topic(topic)
        for title, endpoints in (('Publisher', publishers), ('Subscription', subscriptions)):
            print(f'{title} count: {len(endpoints)}', end=end)
            if options.verbose:
                print(*endpoints, sep=end, end=end if endpoints else '')


def types_of(node: Node, topic: str) -> list[str]:
    """
    Return the types that a topic is published or subscribed with.

    :param topic: its full name.
    """
    return dict(node.get_topic_names_and_types()).get(topic, [])
