"""What a differential base can do, as the search needs it."""

import math
from typing import NamedTuple

from socialnav_core.config import SearchConfig
from socialnav_core.simulation.kinematics import Limits

LEAST_TURN_RATE = 1e-6
"""A base that cannot turn counts as one that takes weeks to, since times are divided by it."""


class Base(NamedTuple):
    """Limits of a base, all finite."""

    speed: float  # no command is faster, m/s
    acceleration: float  # m/s^2
    turn_rate: float  # rad/s
    angular_acceleration: float  # rad/s^2
    reverse: float  # largest speed backwards as a share of the preferred one
    period: float  # time between two commands, s


def base_of(settings: SearchConfig, limits: Limits | None) -> Base:
    """
    Return the base that was handed over; where that says nothing, the one of the settings.

    :param limits: infinite where they say nothing; None where all is left to the settings.
    """
    own = settings.differential
    if limits is None:
        limits = Limits(math.inf, math.inf, math.inf, settings.time_step)
    return Base(
        speed=limits.speed,
        acceleration=finite_or(limits.acceleration, own.acceleration),
        turn_rate=max(finite_or(limits.turn_rate, own.turn_rate), LEAST_TURN_RATE),
        angular_acceleration=finite_or(limits.angular_acceleration, own.angular_acceleration),
        reverse=own.reverse,
        period=limits.period,
    )


def finite_or(limit: float, own: float) -> float:
    """Return a limit, or another number where there is none."""
    return limit if math.isfinite(limit) else own
