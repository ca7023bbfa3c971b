"""How lasers sit on the robot, told by parameters or by tf."""

from collections.abc import Callable
import dataclasses
import math

from geometry_msgs.msg import TransformStamped
import numpy as np

from socialnav.messages.conversions import ConversionError, finite, heading_of
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav_core.sensing import Pose

Transform = Callable[[str, str], TransformStamped]
"""Returns the transform from a frame (second) to another (first); raises LookupError."""
LEVEL = math.cos(math.radians(10.0))
"""A laser that is tilted more than this does not measure along the ground."""
UPSIDE_DOWN = 'upside_down'


@dataclasses.dataclass(frozen=True)
class Mounting:
    """How a laser sits on the robot."""

    pose: Pose
    """Its place and the direction of its x axis, in the frame of the robot."""
    upside_down: bool = False
    """Whether it turns the other way round, seen from above."""

    def placed(self, points: np.ndarray) -> np.ndarray:
        """Return points of the laser as the robot has them, m, (points, 2)."""
        return self.pose.placed(points * [1.0, -1.0] if self.upside_down else points)


class Lasers:
    """Knows how the laser of each scan sits."""

    def __init__(self, settings: ObstacleParameters, transform: Transform) -> None:
        """
        Read what the parameters tell.

        :param transform: asked where `laser_pose` is tf.
        :raises ValueError: parameters that tell too little.
        """
        self.settings, self._transform = settings, transform
        self.topics = settings.scan_topics.split()
        if not self.topics or len(set(self.topics)) < len(self.topics):
            raise ValueError(
                'parameter scan_topics must name topics, each once, and spaces between'
            )
        self._known = mountings(settings.laser_frames)
        self._frames: dict[str, str] = {}
        if len(self.topics) > 1 and settings.laser_pose == 'parameters' and not self._known:
            raise ValueError(
                'several scan_topics need laser_pose tf, or laser_frames, which says how each sits'
            )

    def mounting(self, topic: str, frame: str) -> Mounting:
        """
        Return how the laser of a scan sits.

        :raises ConversionError: nobody says, or it is not level.
        """
        if self._frames.setdefault(topic, frame) != frame:
            raise ConversionError(
                f'{topic}: from frames {self._frames[topic]!r} and {frame!r}: '
                'give each laser a topic of its own and name them in scan_topics'
            )
        if self.settings.laser_pose == 'tf':
            return self._told_by_tf(topic, frame)
        if not self._known:
            return self._single(topic, frame)
        if frame not in self._known:
            raise ConversionError(f'{topic}: in frame {frame!r}, which laser_frames does not name')
        return self._known[frame]

    def _single(self, topic: str, frame: str) -> Mounting:
        """Return how the only laser sits."""
        one = self.settings
        pose, base = Pose(one.laser_x, one.laser_y, one.laser_yaw), one.base_frame
        result = Mounting(pose, one.laser_upside_down)
        if frame == base and result != Mounting(Pose()):
            raise ConversionError(
                f'{topic}: in frame {base!r}, but laser_x and its like say that it is elsewhere'
            )
        return result

    def _told_by_tf(self, topic: str, frame: str) -> Mounting:
        """Return how a laser sits as tf has it."""
        if frame == self.settings.base_frame:
            return Mounting(Pose())
        try:
            return mounting_of(self._transform(self.settings.base_frame, frame))
        except LookupError as error:
            raise ConversionError(f'{topic}: in frame {frame!r}, but {error}') from error


def mountings(text: str) -> dict[str, Mounting]:
    """
    Return how lasers sit by their frames.

    :param text: entries with semicolons between, such as `rear -0.2 0 3.14 upside_down`.
    :raises ValueError: a text that is none.
    """
    found = {}
    for entry in filter(str.strip, text.split(';')):
        frame, *words = entry.split()
        upside_down = words[-1:] == [UPSIDE_DOWN]
        try:
            x, y, yaw = map(float, words[: len(words) - upside_down])
        except ValueError:
            x = y = yaw = math.nan
        if not math.isfinite(x + y + yaw):
            raise ValueError(
                f'parameter laser_frames: {entry.strip()!r} must be a frame, x, y and yaw, '
                f'and perhaps {UPSIDE_DOWN}'
            )
        found[frame] = Mounting(Pose(x, y, yaw), upside_down)
    return found


def mounting_of(transform: TransformStamped) -> Mounting:
    """
    Return how a laser sits whose frame is the child of a transform.

    :raises ConversionError: it is not level, or the transform is none.
    """
    moved, turn = transform.transform.translation, transform.transform.rotation
    x, y = finite('transform', 'translation', [moved.x, moved.y]).tolist()
    heading = heading_of('transform', turn)  # direction of its x axis on the ground
    upwards = 1 - 2 * (turn.x**2 + turn.y**2)  # its z axis, upwards
    if abs(upwards) < LEVEL:
        raise ConversionError(f'the laser of {transform.child_frame_id!r} is tilted')
    return Mounting(Pose(x, y, heading), upwards < 0)
