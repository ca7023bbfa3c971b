"""What the beams of a laser scan say: where they ended, how far they were free."""

import dataclasses
from typing import Annotated

import numpy as np

from socialnav_core.config.ranges import OneOf, Range, require_allowed

MEANING = OneOf(('free', 'failed', 'near'))
"""What a range that is no distance may mean."""
MOST_BEAMS = 20000
"""More beams than any scanner of a robot has."""
WHOLE_TURN = 2 * np.pi + 0.1
"""A scan does not see more than once around, rad; what is added is for rounding."""


@dataclasses.dataclass(frozen=True)
class Readings:
    """
    What the driver of a laser means by ranges that are no distance (REP-117 by default).

    Each means `free`, nothing until the longest range, `failed`, no measurement, or `near`,
    something at the shortest range.
    """

    inf: Annotated[str, MEANING] = 'free'
    """inf."""
    nan: Annotated[str, MEANING] = 'failed'
    """NaN."""
    zero: Annotated[str, MEANING] = 'failed'
    """0."""
    beyond: Annotated[str, MEANING] = 'failed'
    """The longest range, and finite ones above it."""
    least_valid: Annotated[float, Range(0, 1)] = 0.1
    """Share of the beams that must have measured something or nothing."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class Rays:
    """Ways on which nothing is."""

    origin: np.ndarray
    """Where the laser is, m, (2,)."""
    ends: np.ndarray
    """How far the beams were free, m, (beams, 2)."""

    def seen_from(self, place: np.ndarray) -> 'Rays':
        """Return the rays with another point, m, (2,), as the origin of coordinates."""
        return Rays(self.origin - place, self.ends - place)


@dataclasses.dataclass(frozen=True)
class Geometry:
    """The numbers of a scan that are the same for all of its beams."""

    angle_min: float
    """Direction of the first beam, rad."""
    angle_max: float
    """Direction of the last beam, rad."""
    angle_increment: float
    """From beam to beam, rad, of either sign."""
    range_min: float
    """Shortest range, m."""
    range_max: float
    """Longest range, m."""

    def check(self, beams: int) -> None:
        """
        Refuse what no laser measures.

        :raises ValueError: the text says what is wrong.
        """
        numbers = dataclasses.astuple(self)
        if not np.isfinite(numbers[:4]).all() or np.isnan(self.range_max):
            raise ValueError('angles or limits with NaN or infinity')
        if not 0 <= self.range_min < self.range_max:
            raise ValueError(f'ranges from {self.range_min:g} to {self.range_max:g} m')
        if beams > MOST_BEAMS:
            raise ValueError(f'{beams} beams, more than {MOST_BEAMS}')
        turn = self.angle_increment * (beams - 1)
        if np.abs(numbers[:2]).max() > 2 * np.pi + WHOLE_TURN or abs(turn) > WHOLE_TURN:
            raise ValueError(f'{beams} beams by {self.angle_increment:g} rad: more than a turn')
        if beams > 1 and self.angle_increment == 0:
            raise ValueError('an angle of 0 between the beams')
        # drivers count the last beam or do not
        if beams and abs(self.angle_max - self.angle_min - turn) > 1.5 * abs(self.angle_increment):
            raise ValueError(
                f'{beams} beams by {self.angle_increment:g} rad do not lead from '
                f'{self.angle_min:g} to {self.angle_max:g} rad'
            )


def scan_beams(
    ranges: np.ndarray, geometry: Geometry, readings: Readings = Readings(), reach: float = np.inf
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return where beams hit something, m, (returns, 2), and where all that measured end, (beams, 2).

    Both are in the frame of the laser. -inf is nearer than the shortest range and taken to be
    there (REP-117). Ranges below the shortest mean nothing.

    :param ranges: m, (beams,).
    :param reach: free beams end here at the latest, m.
    :raises ValueError: a scan that cannot be, or in which hardly any beam measured anything.
    """
    ranges = np.asarray(ranges, dtype=float)
    geometry.check(len(ranges))
    lengths, free = understood(ranges, geometry, readings)
    valid = np.isfinite(lengths) | free
    if valid.sum() < max(readings.least_valid * len(ranges), 1):
        raise ValueError(f'{valid.sum()} of {len(ranges)} beams measured anything')
    angles = geometry.angle_min + geometry.angle_increment * np.arange(len(ranges))
    rays = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    longest = min(reach, geometry.range_max)
    ends = np.where(free, longest if np.isfinite(longest) else 0.0, lengths)[:, None] * rays
    return ends[valid & ~free], ends[valid]


def understood(
    ranges: np.ndarray, geometry: Geometry, readings: Readings
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return at which distance each beam hit something, m, NaN for none, and which were free.

    :param ranges: m, (beams,).
    """
    near = max(geometry.range_min, 1e-3)  # a surface at the laser itself has no direction
    distance = (ranges > 0) & (ranges >= geometry.range_min) & (ranges < geometry.range_max)
    lengths = np.where(distance & np.isfinite(ranges), ranges, np.nan)
    lengths[np.isneginf(ranges)] = near
    free = np.zeros(len(ranges), dtype=bool)
    special = (
        (np.isposinf(ranges), readings.inf),
        (np.isnan(ranges), readings.nan),
        (ranges == 0, readings.zero),
        (np.isfinite(ranges) & (ranges >= geometry.range_max), readings.beyond),
    )
    for which, meaning in special:
        if meaning == 'near':
            lengths[which] = near
        elif meaning == 'free':
            free |= which
    return lengths, free
