"""What is needed to listen to a topic that is known only by name."""

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.topic_endpoint_info import TopicEndpointInfo

from small_ros2.command import CommandError
from small_ros2.graph import look
from small_ros2.messages import message_class

DEPTH = 10
"""Messages that are kept while one is being printed."""


def find(node: Node, topic: str, kind: str | None = None) -> tuple[type, QoSProfile]:
    """
    Return the class of a topic's messages and a QoS that hears all of its publishers.

    :param topic: its full name.
    :param kind: name of the type, where it need not be asked for.
    :raises CommandError: when the type is not known.
    """
    given = message_class(kind) if kind else None
    look(node, lambda: node.count_publishers(topic))
    return given or class_of(node, topic), matching_qos(node.get_publishers_info_by_topic(topic))


def class_of(node: Node, topic: str) -> type:
    """
    Return the class of a topic's messages.

    :param node: that has looked.
    :param topic: its full name.
    :raises CommandError: when nobody uses the topic, or it has several types.
    """
    types = dict(node.get_topic_names_and_types()).get(topic, [])
    if not types:
        raise CommandError(
            f'WARNING: topic [{topic}] does not appear to be published yet\n'
            'Could not determine the type for the passed topic'
        )
    if len(types) > 1:
        raise CommandError(
            f'Cannot echo topic {topic}, as it contains more than one type: {types}'
        )
    return message_class(types[0])


def matching_qos(publishers: list[TopicEndpointInfo]) -> QoSProfile:
    """Return the strongest QoS that all publishers offer; the weakest when there is none."""
    offers = [publisher.qos_profile for publisher in publishers]
    reliable = {offer.reliability for offer in offers} == {ReliabilityPolicy.RELIABLE}
    latched = {offer.durability for offer in offers} == {DurabilityPolicy.TRANSIENT_LOCAL}
    return QoSProfile(
        depth=DEPTH,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if latched else DurabilityPolicy.VOLATILE,
    )
