"""What a robot can do within a time, starting from the velocity that it has."""

import dataclasses

import numpy as np

from socialnav_core.simulation.kinematics import direction
from socialnav_core.states import CrowdState


@dataclasses.dataclass(frozen=True)
class Limits:
    """Limits of a robot's motion."""

    speed: float
    """Largest speed, m/s."""
    acceleration: float
    """Largest change of velocity, of a differential drive: of speed, m/s^2."""
    turn_rate: float
    """Largest turn rate of a differential drive, rad/s."""
    period: float
    """Time between two commands, s."""


def present_command(kinematics: str, state: CrowdState) -> np.ndarray:
    """
    Return the command that the robot seems to follow, (batch, 2); a turn rate is taken to be 0.

    :param kinematics: holonomic or differential.
    :param state: the worlds as they are.
    """
    if kinematics == 'holonomic':
        return state.robot.velocity
    speed = (state.robot.velocity * direction(state.robot.heading)).sum(axis=-1)
    return np.stack([speed, np.zeros_like(speed)], axis=-1)


def reachable(
    kinematics: str, commands: np.ndarray, present: np.ndarray, limits: Limits, duration: float
) -> np.ndarray:
    """
    Return the nearest commands within the limits; those within them come back unchanged.

    :param kinematics: holonomic or differential.
    :param commands: wanted, (..., 2).
    :param present: the command followed now, (..., 2); its turn rate does not matter.
    :param limits: of the robot; its speed counts more than its acceleration.
    :param duration: time for the change, s.
    """
    change = limits.acceleration * duration
    if kinematics == 'holonomic':
        present = shortened(present, limits.speed)
        wanted = commands - present
        changed = np.where(longer(wanted, change), present + shortened(wanted, change), commands)
        return shortened(changed, limits.speed)
    present_speed = bounded(present[..., 0], limits.speed)
    gain = commands[..., 0] - present_speed
    limited = bounded(gain, change)
    speed = np.where(limited == gain, commands[..., 0], present_speed + limited)
    turn_rate = bounded(commands[..., 1], limits.turn_rate)
    return np.stack([bounded(speed, limits.speed), turn_rate], axis=-1)


def mean_command(kinematics: str, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """
    Return the command that moves as far as an even change from one to another, (..., 2).

    :param kinematics: holonomic, or differential: the turn rate changes at once.
    :param first: command at the beginning, (..., 2).
    :param last: command at the end, (..., 2).
    """
    mean = 0.5 * (first + last)
    if kinematics == 'differential':
        mean[..., 1] = last[..., 1]
    return mean


def bounded(numbers: np.ndarray, limit: float) -> np.ndarray:
    """
    Return numbers brought into [-limit, limit]; those in it, but for rounding, are unchanged.

    :param numbers: of any shape.
    :param limit: the largest magnitude.
    """
    outside = np.abs(numbers) > limit * (1 + 1e-9)
    return np.where(outside, np.clip(numbers, -limit, limit), numbers)


def longer(vectors: np.ndarray, length: float) -> np.ndarray:
    """
    Return which vectors are longer than a length, but for rounding, bool (..., 1).

    :param vectors: (..., 2).
    :param length: the largest that they may have.
    """
    return np.hypot(vectors[..., :1], vectors[..., 1:]) > length * (1 + 1e-9)


def shortened(vectors: np.ndarray, length: float) -> np.ndarray:
    """
    Return vectors cut to a length, (..., 2); those short enough come back unchanged.

    :param vectors: (..., 2).
    :param length: the largest that they may have.
    """
    norm = np.hypot(vectors[..., :1], vectors[..., 1:])
    too_long = longer(vectors, length)
    return vectors * np.where(too_long, length / np.where(too_long, norm, 1.0), 1.0)
