"""Where a robot was, and what it saw from there, in the frame of the world."""

from bisect import bisect_right
from collections import deque
import dataclasses
import math

import numpy as np

MEMORY = 400
"""Number of latest poses that are kept."""


@dataclasses.dataclass(frozen=True)
class Pose:
    """Place and direction of a frame in another one, the outer."""

    x: float = 0.0
    """m."""
    y: float = 0.0
    """m."""
    heading: float = 0.0
    """rad, counter-clockwise."""

    @property
    def position(self) -> np.ndarray:
        """Return the place, m, (2,)."""
        return np.array([self.x, self.y])

    @property
    def rotation(self) -> np.ndarray:
        """Return the matrix that turns rows of vectors, (2, 2)."""
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        return np.array([[cosine, sine], [-sine, cosine]])

    def turned(self, vectors: np.ndarray) -> np.ndarray:
        """Return vectors of the frame, as velocities are, as the outer one has them, (..., 2)."""
        return vectors if self == HERE else vectors @ self.rotation

    def placed(self, points: np.ndarray) -> np.ndarray:
        """Return points of the frame as the outer one has them, m, (..., 2)."""
        return points if self == HERE else points @ self.rotation + self.position

    def found(self, points: np.ndarray) -> np.ndarray:
        """Return points of the outer frame as this one has them, m, (..., 2)."""
        return (points - self.position) @ self.rotation.T

    def of(self, inner: 'Pose') -> 'Pose':
        """Return the pose of what sits at a pose within this frame."""
        x, y = self.placed(inner.position).tolist()
        return Pose(x, y, self.heading + inner.heading)


HERE = Pose()
"""Of a frame that coincides with the outer one."""


@dataclasses.dataclass(frozen=True)
class Motion:
    """A pose and how it was changing."""

    pose: Pose
    """Of the robot."""
    velocity: np.ndarray
    """In the world, m/s, (2,)."""
    turn_rate: float
    """rad/s."""

    def after(self, duration: float) -> Pose:
        """Return the pose after some time, s, at constant velocity."""
        x, y = (self.pose.position + duration * self.velocity).tolist()
        return Pose(x, y, self.pose.heading + duration * self.turn_rate)


class PoseHistory:
    """The latest poses of a robot; a clock that runs backwards empties it."""

    def __init__(self, reach: float) -> None:
        """
        Start without a pose.

        :param reach: longest time over which a pose is interpolated or extrapolated, s.
        """
        self.reach = reach
        self._stamps: deque[int] = deque(maxlen=MEMORY)
        self._motions: deque[Motion] = deque(maxlen=MEMORY)

    def store(self, stamp: int, motion: Motion) -> None:
        """Keep a pose and its time, ns."""
        if self._stamps and stamp < self._stamps[-1]:
            self._stamps.clear()
            self._motions.clear()
        self._stamps.append(stamp)
        self._motions.append(motion)

    def at(self, stamp: int) -> Pose | None:
        """Return the pose at a time, ns, None where no pose is near enough."""
        following = bisect_right(self._stamps, stamp)
        if following == 0:
            return None
        motion, elapsed = self._motions[following - 1], stamp - self._stamps[following - 1]
        if elapsed == 0:
            return motion.pose
        between = following < len(self._stamps)
        gap = self._stamps[following] - self._stamps[following - 1] if between else elapsed
        if gap > self.reach * 1e9:
            return None
        if not between:
            return motion.after(elapsed * 1e-9)
        return interpolated(motion.pose, self._motions[following].pose, elapsed / gap)


def interpolated(first: Pose, second: Pose, fraction: float) -> Pose:
    """Return a pose a fraction of the way between two; the heading turns the shorter way."""
    turn = (second.heading - first.heading + math.pi) % (2 * math.pi) - math.pi
    x, y = (first.position + fraction * (second.position - first.position)).tolist()
    return Pose(x, y, first.heading + fraction * turn)
