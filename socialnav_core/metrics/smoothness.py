"""Metrics of how evenly the robot moves."""

import numpy as np

from socialnav_core.metrics.efficiency import STALLED_SPEED
from socialnav_core.metrics.outcomes import FRANCIS
from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import Average, Metric


def accelerations(records: EpisodeRecords) -> np.ndarray:
    """Return the mean acceleration of each step, m/s^2, (episodes, steps, 2); NaN behind."""
    return np.diff(records.velocity, axis=1) / records.duration[..., None]


def mean_acceleration(records: EpisodeRecords) -> np.ndarray:
    """Return the mean magnitude of the acceleration in each episode, m/s^2, (episodes,)."""
    return mean_magnitude(accelerations(records))


def mean_jerk(records: EpisodeRecords) -> np.ndarray:
    """Return the mean magnitude of the jerk of each episode, m/s^3, (episodes,)."""
    changes = np.diff(accelerations(records), axis=1)
    return mean_magnitude(changes / records.duration[:, 1:, None])


def mean_magnitude(vectors: np.ndarray) -> np.ndarray:
    """
    Return the mean length of the vectors of each episode, (episodes,); NaN where there are none.

    :param vectors: (episodes, vectors, 2), NaN where there is none.
    """
    lengths = np.hypot(vectors[..., 0], vectors[..., 1])
    count = np.isfinite(lengths).sum(axis=1)
    return np.where(count, np.nansum(lengths, axis=1), np.nan) / np.maximum(count, 1)


def heading_changes(records: EpisodeRecords) -> np.ndarray:
    """
    Return how much the direction of motion turns on each metre, rad/m, (episodes,).

    A robot that stands has no direction; the turn is then from the last step in which it moved.
    """
    x, y = records.displacement[..., 0], records.displacement[..., 1]
    moves = np.hypot(x, y) >= STALLED_SPEED * records.duration  # False behind the end
    latest = np.where(moves, np.arange(moves.shape[1]), -1)
    latest = np.maximum.accumulate(latest, axis=1)[:, :-1]  # last moving step before each
    direction = np.arctan2(y, x)
    before = np.take_along_axis(direction, np.maximum(latest, 0), axis=1)
    turn = np.abs(np.angle(np.exp(1j * (direction[:, 1:] - before))))
    total = np.where(moves[:, 1:] & (latest >= 0), turn, 0.0).sum(axis=1)
    drove = records.path_length > 0.0
    return np.where(drove, total, np.nan) / np.where(drove, records.path_length, 1.0)


METRICS = (
    Metric(
        name='mean_acceleration', label='acceleration of successes', heading='acceleration',
        unit='m/s^2', measure=mean_acceleration, average=Average.SUCCESSES, source=FRANCIS,
        formula='mean over the steps k of |a(k)|, a(k) = (v(k+1) - v(k)) / dt, v the velocity of '
        'the robot, at rest before the first step',
    ),
    Metric(
        name='mean_jerk', label='jerk of successes', heading='jerk', unit='m/s^3',
        measure=mean_jerk, average=Average.SUCCESSES, source=FRANCIS,
        formula='mean over the steps k of |a(k+1) - a(k)| / dt',
    ),
    Metric(
        name='heading_changes', label='heading changes of successes', heading='zig-zag',
        unit='rad/m', measure=heading_changes, average=Average.SUCCESSES,
        source='Guzzi et al. 2013, Human-friendly Robot Navigation in Dynamic Environments '
        '(path irregularity), without subtracting the turns that are needed',
        formula='sum of the angles between the directions of successive steps in which the robot '
        'moves, divided by the path driven',
    ),
)  # fmt: skip
