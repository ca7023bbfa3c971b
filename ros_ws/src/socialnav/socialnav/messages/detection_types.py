"""Which types of messages tell where people are, and where in them the positions stand."""

from collections.abc import Callable
import dataclasses
from importlib import import_module
from typing import Any

from geometry_msgs.msg import Point

PERSON = 1
"""Type of a person in hunav_msgs/Agent."""
PEDESTRIAN = 4
"""Classification of a pedestrian in derived_object_msgs/Object."""


@dataclasses.dataclass(frozen=True)
class DetectionType:
    """A type of messages with a header, whose package need not be installed."""

    package: str
    """Package that defines it."""
    name: str
    """Its name there."""
    places: Callable[[Any], list[Point]]
    """Returns the positions of the people in a message."""


DETECTION_TYPES = {
    'poses': DetectionType(
        'geometry_msgs', 'PoseArray', lambda message: [one.position for one in message.poses]
    ),
    'agents': DetectionType(
        'socialnav_msgs', 'AgentStates', lambda message: [one.position for one in message.agents]
    ),
    'people_msgs': DetectionType(
        'people_msgs', 'People', lambda message: [one.position for one in message.people]
    ),
    'hunav_msgs': DetectionType(
        'hunav_msgs',
        'Agents',
        lambda message: [one.position.position for one in message.agents if one.type == PERSON],
    ),
    'vision_msgs': DetectionType(
        'vision_msgs',
        'Detection3DArray',
        lambda message: [one.bbox.center.position for one in message.detections],
    ),
    'derived_object_msgs': DetectionType(
        'derived_object_msgs',
        'ObjectArray',
        lambda message: [
            one.pose.position for one in message.objects if one.classification == PEDESTRIAN
        ],
    ),
}
"""What detections may be, by the value of the parameter `source`."""


def message_class(kind: DetectionType) -> type:
    """
    Return the class of a type of messages.

    :raises ValueError: when its package cannot be imported.
    """
    try:
        return getattr(import_module(f'{kind.package}.msg'), kind.name)
    except ImportError as error:
        raise ValueError(
            f'source {kind.package} needs the package of this name: install and source it'
        ) from error
