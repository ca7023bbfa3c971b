"""The last limit on a command; a policy that knows the limits never meets it."""

import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Limits:
    """What the robot can do."""

    speed: float
    """Largest speed, m/s."""
    acceleration: float
    """Largest change of velocity, m/s^2."""
    turn_rate: float
    """Largest turn rate, rad/s."""


def clamp_holonomic(
    velocity: np.ndarray, present: np.ndarray, limits: Limits, period: float
) -> np.ndarray:
    """
    Return the nearest velocity within the limits.

    :param velocity: wanted, (2,).
    :param present: of the robot, in the same frame, (2,).
    :param limits: what the robot can do.
    :param period: time until the next command, s.
    """
    change = shortened(velocity - present, limits.acceleration * period)
    reachable = velocity if change is None else present + change
    slower = shortened(reachable, limits.speed)
    return reachable if slower is None else slower


def clamp_differential(
    command: np.ndarray, present_speed: float, limits: Limits, period: float
) -> np.ndarray:
    """
    Return the nearest speed and turn rate within the limits.

    :param command: wanted speed and turn rate, (2,).
    :param present_speed: forward speed of the robot, m/s.
    :param limits: what the robot can do.
    :param period: time until the next command, s.
    """
    change = limits.acceleration * period
    speed = np.clip(command[0], present_speed - change, present_speed + change)
    return np.array(
        [
            np.clip(speed, -limits.speed, limits.speed),
            np.clip(command[1], -limits.turn_rate, limits.turn_rate),
        ]
    )


def shortened(vector: np.ndarray, length: float) -> np.ndarray | None:
    """
    Return a vector cut to a length, or None where it is short enough (but for rounding).

    :param vector: (2,).
    :param length: the largest that it may have.
    """
    norm = float(np.hypot(vector[0], vector[1]))
    return vector * (length / norm) if norm > length * (1 + 1e-9) else None
