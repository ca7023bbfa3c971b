"""Scenarios of recorded people, by the names of their files."""

from collections.abc import Mapping
import math
import re
from typing import Any

import numpy as np

from socialnav_core.config.appearances import slots_of
from socialnav_core.config.mapping import as_float, require
from socialnav_core.config.ranges import rules_of
from socialnav_core.config.recordings import file_digest, INTERVAL, read_tracks
from socialnav_core.config.scenario import RECORDED, RecordingConfig, RewardConfig, Scenario

RECORDED_NAME = re.compile(rf'({"|".join(RECORDED)}):([^\n]+)')
"""Name of such a scenario: the crowd, a colon and the path of the file."""
TRAVEL = (8.0, 15.0)
"""The robot goes at least and at most so far, m, where the scene is large enough."""
TRAVEL_SHARE = 0.6
"""In small scenes it goes at least this part of the longer side."""
MARGIN = 1.0
"""The robot may leave the square that holds all recorded places by this, m."""


def recorded_scenario(name: str, crowd: str, file: str, interval: float) -> Scenario:
    """
    Return the world of a file of recorded people.

    :param crowd: one of RECORDED.
    :param interval: between two annotated frames, s.
    :raises ConfigError: for a file that holds no recorded people.
    """
    tracks = read_tracks(file, interval)
    slots = slots_of(tracks, interval)
    require(slots > 0, f'{file}: nobody is seen twice within 2 s')
    size = np.nanmax(tracks, axis=(0, 1)) - np.nanmin(tracks, axis=(0, 1))
    least = min(TRAVEL[0], TRAVEL_SHARE * float(size.max()))
    return Scenario(
        name,
        pedestrians=slots,
        obstacles=0,
        layout='recorded',
        minimum_travel=least,
        maximum_travel=TRAVEL[1],
        bounds=math.ceil(10.0 * (0.5 * float(size.max()) + MARGIN)) / 10.0,
        robot_visible=crowd == 'recorded_reactive',
        crowd=crowd,
        reward=RewardConfig(walls_discomfort=False),
        recording=RecordingConfig(file, interval, file_digest(file)),
    )


def recorded_interval(settings: Mapping[str, Any]) -> float:
    """Return the interval between frames among settings, or the usual one; s."""
    given = as_float(settings.get('recording.interval', INTERVAL))
    allowed = rules_of(RecordingConfig)['interval'][1].refusal(given) is None  # type: ignore[arg-type]
    return float(given) if allowed else INTERVAL  # what is refused is told when it is set


def centre_of(tracks: np.ndarray) -> np.ndarray:
    """Return the middle of the square that holds all recorded places, m, (2,)."""
    return 0.5 * (np.nanmax(tracks, axis=(0, 1)) + np.nanmin(tracks, axis=(0, 1)))
