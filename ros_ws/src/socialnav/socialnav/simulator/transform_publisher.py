"""The simulator's frames for tf2, where its messages are installed."""

from importlib.util import find_spec
from typing import Any

from geometry_msgs.msg import TransformStamped, Vector3
from nav_msgs.msg import Odometry
from rclpy.node import Node

from socialnav import qos
from socialnav.messages.stamps import header_message
from socialnav.simulator.world_messages import Frames


def transform_of_robot(odometry: Odometry) -> TransformStamped:
    """Return where the robot is."""
    place = odometry.pose.pose.position
    transform = TransformStamped(header=odometry.header, child_frame_id=odometry.child_frame_id)
    transform.transform.translation = Vector3(x=place.x, y=place.y, z=place.z)
    transform.transform.rotation = odometry.pose.pose.orientation
    return transform


def transform_of_map(frames: Frames, nanoseconds: int) -> TransformStamped:
    """Return that the frame of everything else coincides with the map from a time on."""
    header = header_message(nanoseconds, frames.map)
    return TransformStamped(header=header, child_frame_id=frames.odom)


class TransformPublisher:
    """Tells tf2 of the robot and, once, of the map."""

    def __init__(self, node: Node, frames: Frames, kind: Any, nanoseconds: int) -> None:
        """
        Tell of the map.

        :param kind: tf2_msgs.msg.TFMessage.
        :param nanoseconds: time of the first state.
        """
        self._kind = kind
        self._moving = node.create_publisher(kind, '/tf', qos.TRANSFORMS)
        self._standing = node.create_publisher(kind, '/tf_static', qos.STATIC_TRANSFORMS)
        self._standing.publish(kind(transforms=[transform_of_map(frames, nanoseconds)]))

    def publish(self, odometry: Odometry) -> None:
        """Tell of the robot."""
        self._moving.publish(self._kind(transforms=[transform_of_robot(odometry)]))


def transform_publisher(node: Node, frames: Frames, nanoseconds: int) -> TransformPublisher | None:
    """
    Return what tells tf2 of the frames; None where its messages are not installed.

    :param nanoseconds: time of the first state.
    """
    if find_spec('tf2_msgs') is None:
        return None
    from tf2_msgs.msg import TFMessage

    return TransformPublisher(node, frames, TFMessage, nanoseconds)
