"""Where frames lie, as tf2 knows it where it is installed."""

from importlib.util import find_spec
from typing import Any

from geometry_msgs.msg import TransformStamped
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time

from socialnav.messages.conversions import ConversionError, finite, heading_of
from socialnav_core.sensing import Pose

WAIT = Duration(nanoseconds=100_000_000)
"""How long it is waited for a transform that has not come yet."""


class Transforms:
    """Asks tf2; listens only from the first question on, since most robots need none."""

    def __init__(self, node: Node) -> None:
        """
        Do not listen yet.

        :param node: whose name and context are used.
        """
        self._owner = node
        self._listening: tuple[Any, Any, Node] | None = None

    def locate(self, frame: str, source: str, stamp: int) -> Pose:
        """
        Return where `source` lies in `frame`; this may take 0.1 s.

        :param stamp: at this time, ns; 0 for the newest that is known.
        :raises LookupError: nobody knows, or tf2 is not there; the text says so.
        """
        try:
            return placement_of_transform(self.transform(frame, source, stamp))
        except ConversionError as error:
            raise LookupError(f'there is no transform to {frame!r}: {error}') from error

    def transform(self, frame: str, source: str, stamp: int = 0) -> TransformStamped:
        """
        Return the transform from `source` to `frame`; this may take 0.1 s.

        :param stamp: at this time, ns; 0 for the newest that is known.
        :raises LookupError: nobody knows, or tf2 is not there; the text says so.
        """
        if find_spec('tf2_ros') is None:
            raise LookupError(f'everything must be in {frame!r}, since tf2_ros is not installed')
        import tf2_ros

        buffer = self._buffer(tf2_ros)
        try:
            return buffer.lookup_transform(frame, source, Time(nanoseconds=stamp), WAIT)
        except tf2_ros.TransformException as error:
            raise LookupError(f'there is no transform to {frame!r}: {error}') from error

    def _buffer(self, tf2_ros: Any) -> Any:
        """Return what remembers transforms, heard by a node and in a thread of its own."""
        if self._listening is None:
            name = f'{self._owner.get_name()}_transforms'
            node = rclpy.create_node(
                name, context=self._owner.context, use_global_arguments=False,
                start_parameter_services=False,
            )  # fmt: skip
            buffer = tf2_ros.Buffer()
            listener = tf2_ros.TransformListener(buffer, node, spin_thread=True)
            self._listening = buffer, listener, node
        return self._listening[0]

    def close(self) -> None:
        """Stop listening."""
        if self._listening is not None:
            _, listener, node = self._listening
            listener.executor.shutdown()
            listener.dedicated_listener_thread.join()
            self._listening = None
            node.destroy_node()


def placement_of_transform(transform: TransformStamped) -> Pose:
    """
    Return where the child frame of a transform lies in its parent, on the ground.

    :raises ConversionError: a transform that is none.
    """
    moved, rotation = transform.transform.translation, transform.transform.rotation
    x, y = finite('transform', 'translation', [moved.x, moved.y]).tolist()
    return Pose(x, y, heading_of('transform', rotation))
