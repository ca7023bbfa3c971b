"""
Predictions of recorded people as the field of trajectory forecasting measures them.

Who is seen for 8 frames is predicted for the 12 that follow (3.2 s and 4.8 s at 0.4 s); average
and final displacement error are means over all such stretches of all people (Pellegrini et al.
2009).
"""

from typing import NamedTuple

import numpy as np

from socialnav_core.config import ConfigError
from socialnav_core.evaluation.recorded_people import TIME_STEP, track_moments
from socialnav_core.prediction.protocol import Predictor

OBSERVED, PREDICTED = 8, 12
"""Frames."""


class Forecast(NamedTuple):
    """How far predictions are from what people did."""

    average: float
    """Distance, mean over the predicted frames, m (ADE)."""
    final: float
    """Distance in the last frame, m (FDE)."""
    stretches: int
    """Number of predictions."""


def forecast_errors(predictor: Predictor | None, tracks: np.ndarray) -> Forecast:
    """
    Return the displacement errors of a predictor on a recording.

    Modes count by their weights: this is no best of several.

    :param predictor: None for constant velocity.
    :param tracks: m, NaN where somebody is not there, (frames, people, 2).
    :raises ConfigError: when nobody is seen for long enough.
    """
    known = np.isfinite(tracks[..., 0])
    times = TIME_STEP * np.arange(1, PREDICTED + 1)
    errors = []
    if predictor is not None:
        predictor.reset()
    for frame, (state, _) in enumerate(track_moments(tracks), 1):
        if frame + PREDICTED >= len(tracks):
            break
        begin = max(frame + 1 - OBSERVED, 0)
        whole = known[begin : frame + PREDICTED + 1].all(axis=0) & (frame + 1 >= OBSERVED)
        if predictor is None:
            agents = state.agents
            there = agents.position + agents.velocity * times[:, None, None]
            positions, weights = there[None], np.ones(1)
        else:
            prediction = predictor.predict(state, times)  # asked in every frame: it remembers
            positions, weights = prediction.positions[0], prediction.weights[0]
        miss = positions - tracks[frame + 1 : frame + PREDICTED + 1]
        distance = np.tensordot(weights, np.linalg.norm(miss, axis=-1), axes=1)
        errors.append(distance[:, whole].T)
    every = np.concatenate(errors) if errors else np.empty((0, PREDICTED))
    if not len(every):
        raise ConfigError(f'nobody is seen for {OBSERVED + PREDICTED} frames')
    return Forecast(float(every.mean()), float(every[:, -1].mean()), len(every))
