"""What the graph tells of the nodes at the other ends of topics."""

import contextlib
from typing import Any

from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.subscription import Subscription
from rclpy.topic_endpoint_info import TopicEndpointInfo

COMMANDS = ('geometry_msgs/msg/Twist', 'geometry_msgs/msg/TwistStamped')


def rivals(node: Node, commands: Publisher) -> list[str]:
    """Return the other nodes that publish commands."""
    return others_at(node, commands.topic_name)


def others_at(node: Node, topic: str) -> list[str]:
    """Return the other nodes that publish a topic, given by its full name."""
    names = [name_of(one) for one in node.get_publishers_info_by_topic(topic)]
    with contextlib.suppress(ValueError):
        names.remove(node.get_fully_qualified_name())
    return sorted(names)


def concerns_of_base(node: Node, commands: Publisher, stamped: bool, driving: bool) -> list[str]:
    """
    Return what keeps a base from hearing commands.

    :param stamped: whether TwistStamped is sent.
    :param driving: whether it matters that nobody listens.
    """
    ends = node.get_subscriptions_info_by_topic(commands.topic_name)
    sent, other = COMMANDS[stamped], COMMANDS[not stamped]
    deaf = sorted({name_of(one) for one in ends if one.topic_type == other})
    if deaf:
        change = f'set enable_stamped_cmd_vel {str(not stamped).lower()}'
        return [f'{", ".join(deaf)} wants {short(other)}, but {short(sent)} is sent: {change}']
    return [] if ends or not driving else [f'nobody listens to {commands.topic_name}']


def concerns_of_input(node: Node, heard: Subscription, expected: bool) -> list[str]:
    """
    Return what keeps an input that is missed from coming, as far as the graph tells.

    :param expected: whether somebody should publish it all the time.
    """
    ends = node.get_publishers_info_by_topic(heard.topic_name)
    kind: Any = heard.msg_type
    wanted = f'{kind.__module__.split(".")[0]}/msg/{kind.__name__}'
    if not ends and expected:
        return [f'nobody publishes {heard.topic_name}']
    return sorted(
        f'{name_of(one)} publishes {heard.topic_name} as {short(one.topic_type)}, '
        f'not as {short(wanted)}'
        for one in ends
        if one.topic_type != wanted
    )


def name_of(end: TopicEndpointInfo) -> str:
    """Return the full name of the node that an end of a topic belongs to."""
    return f'{end.node_namespace.rstrip("/")}/{end.node_name}'


def short(kind: str) -> str:
    """Return the name of a type without its middle."""
    return kind.replace('/msg/', '/')
