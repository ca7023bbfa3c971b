"""A small base that knows nothing of this project: it drives as cmd_vel says, as far as it can."""

from collections import deque
import dataclasses
import math

import numpy as np


@dataclasses.dataclass
class Pose:
    """A place and a direction in the plane."""

    place: np.ndarray
    """m, (2,)."""
    heading: float = 0.0
    """rad."""

    def placed(self, point):
        """Return where a point of the frame that this pose is the origin of lies, m, (2,)."""
        return self.place + turned(point, self.heading)

    def seen(self, point):
        """Return a point as the frame that this pose is the origin of has it, m, (2,)."""
        return turned(np.asarray(point) - self.place, -self.heading)

    def moved(self, velocity, rate, duration):
        """Return where one is after driving by a velocity, (2,), and a turn rate of its own."""
        middle = self.heading + rate * duration / 2
        place = self.place + turned(np.asarray(velocity), middle) * duration
        return Pose(place, self.heading + rate * duration)


@dataclasses.dataclass(frozen=True)
class Build:
    """What a base is like."""

    differential: bool = False
    """Whether it drives where it looks only."""
    speed: float = 1.0
    """Largest speed, m/s."""
    acceleration: float = 2.0
    """Largest change of it, m/s^2."""
    turn_rate: float = 2.0
    """Largest turn rate, rad/s."""
    turn_acceleration: float = 6.0
    """Largest change of it, rad/s^2."""
    delay: float = 0.1
    """Time until it hears a command, s."""
    slip: float = 0.04
    """Share of the way of its wheels that is lost to the floor."""
    drift: float = 0.003
    """What it turns by without a wheel telling, rad/m."""
    timeout: float = 0.5
    """Time without a command after which it brakes, s."""


class Base:
    """A base on a floor, and what its wheels tell."""

    def __init__(self, build: Build, pose: Pose, origin: Pose) -> None:
        """
        Stand.

        :param pose: where it stands on the map.
        :param origin: of its odometry on the map, which only the base itself believes in.
        """
        self.build, self.pose, self.time = build, pose, 0.0
        self.told = Pose(origin.seen(pose.place), pose.heading - origin.heading)
        self.velocity, self.rate = np.zeros(2), 0.0
        self._coming: deque[tuple[float, np.ndarray, float]] = deque()
        self._heard, self._wanted, self._wanted_rate = -math.inf, np.zeros(2), 0.0

    def command(self, forwards: float, left: float, rate: float) -> None:
        """Take a command in m/s and rad/s, which the base hears a little later."""
        when = self.time + self.build.delay
        self._coming.append((when, np.array([forwards, left]), rate))

    def advance(self, duration: float) -> None:
        """Drive for some time, s."""
        build = self.build
        self.time += duration
        while self._coming and self._coming[0][0] <= self.time:
            self._heard, self._wanted, self._wanted_rate = self._coming.popleft()
        if self.time - self._heard > build.timeout:
            self._wanted, self._wanted_rate = np.zeros(2), 0.0
        wanted = self._wanted * [1.0, 0.0] if build.differential else self._wanted
        wanted = shortened(wanted, build.speed)
        self.velocity = self.velocity + shortened(
            wanted - self.velocity, build.acceleration * duration
        )
        rate = float(np.clip(self._wanted_rate, -build.turn_rate, build.turn_rate))
        most = build.turn_acceleration * duration
        self.rate += float(np.clip(rate - self.rate, -most, most))
        self.told = self.told.moved(self.velocity, self.rate, duration)
        kept, speed = 1 - build.slip, float(np.hypot(*self.velocity))
        self.pose = self.pose.moved(
            kept * self.velocity, kept * self.rate + build.drift * speed, duration
        )

    def in_odom(self, point):
        """Return where a point of the map is, as seen from here and by odometry, m, (2,)."""
        return self.told.placed(self.pose.seen(point))

    def turned_to_odom(self, vector):
        """Return a vector of the map as odometry has it, (2,)."""
        return turned(vector, self.told.heading - self.pose.heading)


def turned(vector, angle: float):
    """Return a vector, (2,), turned by an angle, rad."""
    x, y = vector
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([cosine * x - sine * y, sine * x + cosine * y])


def shortened(vector, longest: float):
    """Return a vector, (2,), cut to a length."""
    size = float(np.hypot(*vector))
    return vector if size <= longest else vector * (longest / size)
