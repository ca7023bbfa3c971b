"""Who of the recorded people is there from when until when, and in which slot of a world."""

from typing import NamedTuple

import numpy as np

from socialnav_core.config.recordings import LONGEST_GAP

REST = 2.0
"""
A slot stays empty at least this long between two people, s: whoever tells people apart by slots,
and remembers the last 1.5 s, then never takes one for the other.
"""


class Appearance(NamedTuple):
    """A person who comes, is seen without a long gap, and goes."""

    person: int
    """Column of the tracks."""
    frames: np.ndarray
    """Where they are annotated, ascending, (at least 2,)."""
    slot: int
    """Slot of the worlds that they take."""


def appearances_of(tracks: np.ndarray, interval: float) -> list[Appearance]:
    """
    Return all appearances of two annotations and more, in the order in which they begin.

    Each takes the first slot that is free.

    :param tracks: m, NaN where somebody is not there, (frames, people, 2).
    :param interval: between two frames, s.
    """
    parts = []
    for person in range(tracks.shape[1]):
        frames = np.flatnonzero(np.isfinite(tracks[:, person, 0]))
        gaps = np.flatnonzero(np.diff(frames) * interval > LONGEST_GAP + 1e-9) + 1
        parts += [(person, part) for part in np.split(frames, gaps) if len(part) > 1]
    parts.sort(key=lambda part: (part[1][0], part[0]))
    free_from: list[float] = []
    appearances = []
    for person, frames in parts:
        begin, end = frames[0] * interval, frames[-1] * interval
        slot = next((i for i, time in enumerate(free_from) if time <= begin), len(free_from))
        free_from[slot : slot + 1] = [end + REST]
        appearances.append(Appearance(person, frames, slot))
    return appearances


def slots_of(tracks: np.ndarray, interval: float) -> int:
    """Return how many slots a world needs for all recorded people."""
    return max((each.slot + 1 for each in appearances_of(tracks, interval)), default=0)
