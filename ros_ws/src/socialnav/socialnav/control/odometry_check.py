"""Odometry compared with itself: whether the pose moves as the twist says."""

from collections import deque
import dataclasses
import math

from geometry_msgs.msg import Quaternion
from nav_msgs.msg import Odometry
import numpy as np

from socialnav.messages.conversions import twist_stands
from socialnav.messages.stamps import nanoseconds_of
from socialnav_core.simulation.kinematics.angles import rotated

LONGEST = 1.0
"""Poses farther apart in time tell nothing about how the robot moved in between, s."""
JUMP, TURN = 0.5, 0.8
"""What a pose may be off what its twist led to, besides what the robot can drive, m and rad."""
LARGEST_TURN_RATE = 2.0
"""How fast a robot may turn beside what its twist says, rad/s."""
STANDSTILL = 0.05
"""Slower motion of pose and twist is noise, m/s."""
CHUNK = 0.3
"""Way after which pose and twist are compared, m."""
UNLIKE = 0.5
"""Share of that way by which they differ where they do not fit."""
JUDGED = 3
"""Number of such ways after which it is said what is wrong, or nothing any more."""
FROZEN = 'the pose stands while the twist moves: is the localisation, or the pose, stuck?'
SILENT = 'the pose moves while the twist is zero: velocities are not filled in'
UNFIT = (
    'pose and twist do not fit: check the scale and the signs of its velocities, wheel slip, and '
    'its orientation'
)


@dataclasses.dataclass(frozen=True)
class Moved:
    """What happened between two messages of odometry, in the frame of their poses."""

    duration: float
    """Time between them, s."""
    way: np.ndarray
    """How far the pose went, m, (2,)."""
    turn: float
    """How far it turned, rad in [-pi, pi]."""
    told: np.ndarray
    """How far the twist says, m, (2,)."""
    told_turn: float
    """How far it says that the robot turned, rad."""
    otherwise: np.ndarray
    """How far the twist says if it is in the other frame than it should be, m, (2,)."""
    stands: bool
    """Whether the twist should be in the frame of the pose, not in that of the robot."""


def moved(before: Odometry | None, after: Odometry, base_frame: str) -> Moved | None:
    """
    Return what happened between two messages, None where they cannot be compared.

    :param base_frame: frame of the robot.
    """
    if before is None or before.header.frame_id != after.header.frame_id:
        return None
    duration = (nanoseconds_of(after.header.stamp) - nanoseconds_of(before.header.stamp)) * 1e-9
    if not duration > 0:
        return None
    begin, end = (yaw_of(one.pose.pose.orientation) for one in (before, after))
    turn = math.remainder(end - begin, 2 * math.pi)
    velocity = (velocity_of(before) + velocity_of(after)) / 2
    turned = rotated(velocity, begin + turn / 2)
    stands = twist_stands(after, base_frame)
    told, otherwise = (velocity, turned) if stands else (turned, velocity)
    rate = (before.twist.twist.angular.z + after.twist.twist.angular.z) / 2
    way = place_of(after) - place_of(before)
    return Moved(
        duration, way, turn, told * duration, rate * duration, otherwise * duration, stands
    )


class Jumps:
    """Tells where a pose is not where the robot can have gone."""

    def found(self, step: Moved, speed: float) -> str | None:
        """
        Return what is wrong, or None.

        :param speed: largest one of the robot, m/s.
        """
        speed = max(speed, float(np.hypot(*step.told)) / step.duration)
        off = min(float(np.hypot(*(step.way - told))) for told in (step.told, step.otherwise))
        if off > JUMP + speed * step.duration:
            return f'odom jumped by {off:.1f} m within {step.duration:.2f} s'
        turned = abs(math.remainder(step.turn - step.told_turn, 2 * math.pi))
        if turned > TURN + LARGEST_TURN_RATE * step.duration:
            degrees = math.degrees(turned)
            return f'odom turned by {degrees:.0f} degrees within {step.duration:.2f} s'
        return None


class MotionCheck:
    """Compares the ways of pose and twist, a short way at a time."""

    def __init__(self) -> None:
        """Have seen nothing."""
        self.complaint: str | None = None
        self._judged: deque[str | None] = deque(maxlen=JUDGED)
        self._way = self._told = self._otherwise = np.zeros(2)

    def take(self, step: Moved | None) -> None:
        """Take a step; None, or one that is too long, tells nothing."""
        if step is None or step.duration > LONGEST:
            self._begin()
            return
        if max(length(step.way), length(step.told)) < STANDSTILL * step.duration:
            return
        self._way = self._way + step.way
        self._told = self._told + step.told
        self._otherwise = self._otherwise + step.otherwise
        if max(map(length, (self._way, self._told, self._otherwise))) >= CHUNK:
            self._judged.append(self._judgement(step.stands))
            self._begin()
            if len(self._judged) == JUDGED and len(set(self._judged)) == 1:
                self.complaint = self._judged[0]

    def _begin(self) -> None:
        """Begin another way."""
        self._way = self._told = self._otherwise = np.zeros(2)

    def _judgement(self, stands: bool) -> str | None:
        """Return what is wrong with the way so far, with the probable cause, or None."""
        way, told, otherwise = self._way, self._told, self._otherwise
        if not unlike(way, told):
            return None
        if length(way) < CHUNK / 10:
            return f'odom: {FROZEN}'
        if length(told) < CHUNK / 10:
            return f'odom: {SILENT}'
        if not unlike(way, otherwise):
            frames = ('that of the robot', 'that of the pose')
            found, named = frames if stands else frames[::-1]
            return f'odom: its twist is in the frame {found[5:]}, but child_frame_id names {named}'
        return f'odom: {UNFIT}'


def unlike(one: np.ndarray, other: np.ndarray) -> bool:
    """Return whether two ways, m, (2,), differ by a large share of the longer one."""
    return length(one - other) > UNLIKE * max(length(one), length(other))


def length(way: np.ndarray) -> float:
    """Return how long a way is, m."""
    return float(np.hypot(way[0], way[1]))


def yaw_of(rotation: Quaternion) -> float:
    """Return the heading of a rotation that has been checked, rad."""
    x, y, z, w = rotation.x, rotation.y, rotation.z, rotation.w
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def place_of(odometry: Odometry) -> np.ndarray:
    """Return the place of a pose, m, (2,)."""
    position = odometry.pose.pose.position
    return np.array([position.x, position.y])


def velocity_of(odometry: Odometry) -> np.ndarray:
    """Return the velocity of a twist in its own frame, m/s, (2,)."""
    linear = odometry.twist.twist.linear
    return np.array([linear.x, linear.y])
