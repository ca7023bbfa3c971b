"""What a robot can do at all, and the cutting of numbers and vectors to it."""

import dataclasses
import math
from typing import Annotated

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.config.ranges import Range, require_allowed

ROUNDING = 1 + 1e-9
"""Factor of a limit within which a number still counts as inside."""
ANY = Range(0, math.inf)


@dataclasses.dataclass(frozen=True)
class Limits:
    """Limits of a robot's motion."""

    speed: Annotated[float, ANY]
    """Largest speed, m/s."""
    acceleration: Annotated[float, ANY]
    """Largest change of velocity, of a differential drive: of speed, m/s^2."""
    turn_rate: Annotated[float, ANY]
    """Largest turn rate of a differential drive, rad/s."""
    period: Annotated[float, Range(1e-6, 1000)]
    """Time between two commands, s."""
    angular_acceleration: Annotated[float, ANY] = math.inf
    """Largest change of the turn rate of a differential drive, rad/s^2."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


def limits_of(scenario: Scenario) -> Limits | None:
    """Return what the robot of a scenario can do in a step, None where it can do anything."""
    changes = (
        scenario.robot_acceleration, scenario.robot_turn_rate, scenario.robot_angular_acceleration
    )  # fmt: skip
    if all(map(math.isinf, changes)):
        return None
    acceleration, turn_rate, angular_acceleration = changes
    return Limits(
        scenario.robot_preferred_speed, acceleration, turn_rate, scenario.time_step,
        angular_acceleration,
    )  # fmt: skip


def bounded(numbers: np.ndarray, limit: float) -> np.ndarray:
    """Return numbers brought into [-limit, limit]; those in it, but for rounding, stay."""
    outside = np.abs(numbers) > limit * ROUNDING
    return np.where(outside, np.clip(numbers, -limit, limit), numbers)


def changed(present: np.ndarray, wanted: np.ndarray, largest: float, change: float) -> np.ndarray:
    """Return the numbers nearest to those wanted within a size, and a change from the present."""
    present = bounded(present, largest)
    gain = wanted - present
    limited = bounded(gain, change)
    # a gain within bounds must give the very number, which a sum of differences does not
    return bounded(np.where(limited == gain, wanted, present + limited), largest)


def longer(vectors: np.ndarray, length: float) -> np.ndarray:
    """Return which vectors, (..., 2), are longer than a length, but for rounding, (..., 1)."""
    return np.hypot(vectors[..., :1], vectors[..., 1:]) > length * ROUNDING


def shortened(vectors: np.ndarray, length: float) -> np.ndarray:
    """Return vectors, (..., 2), cut to a length; those short enough come back unchanged."""
    norm = np.hypot(vectors[..., :1], vectors[..., 1:])
    too_long = longer(vectors, length)
    return vectors * np.where(too_long, length / np.where(too_long, norm, 1.0), 1.0)
