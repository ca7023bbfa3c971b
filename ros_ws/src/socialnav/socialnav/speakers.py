"""Who publishes the lists that are merged."""

from collections.abc import Callable, Sequence
import time

from rclpy.node import Node
from rclpy.subscription import Subscription

from socialnav.control.inputs import LISTS

PERIOD = 1.0
"""Longest time between two looks at the graph, s."""
UNKNOWN = '_NODE_NAME_UNKNOWN_'
"""Name of the node of a publisher of which only the topic is known so far."""


class Speakers:
    """Tells who publishes each list, when their number changes and now and then."""

    def __init__(
        self,
        node: Node,
        subscriptions: Sequence[Subscription],
        tell: Callable[[str, list[str]], None],
    ) -> None:
        """
        Take the subscriptions to lists among those of a node.

        :param tell: takes the topic's name, without any renaming, and the full names of nodes.
        """
        names = {node.resolve_topic_name(name): name for name in LISTS}
        self.lists = {
            names[one.topic_name]: one for one in subscriptions if one.topic_name in names
        }
        self.node, self.tell = node, tell
        self.counts: dict[str, int] = {}
        self.looked = 0.0

    def look(self) -> None:
        """Look at the graph where that is due."""
        counts = {name: one.get_publisher_count() for name, one in self.lists.items()}
        now = time.monotonic()
        if counts == self.counts and now - self.looked < PERIOD:
            return
        self.counts, self.looked = counts, now
        for name, subscription in self.lists.items():
            publishers = publishers_of(self.node, subscription.topic_name)
            if not any(UNKNOWN in one for one in publishers):
                self.tell(name, publishers)


def publishers_of(node: Node, topic: str) -> list[str]:
    """Return the full names of the nodes that publish a topic, each as often as it does."""
    ends = node.get_publishers_info_by_topic(topic)
    return [f'{one.node_namespace.rstrip("/")}/{one.node_name}' for one in ends]
