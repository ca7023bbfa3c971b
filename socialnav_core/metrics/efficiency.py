"""Metrics of how soon and on what way the robot arrives."""

import numpy as np

from socialnav_core.metrics.outcomes import FRANCIS
from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import Average, Metric, Place

STALLED_SPEED = 0.05
"""Mean speed over a step below which the robot counts as standing, m/s."""


def success_by_path_length(records: EpisodeRecords) -> np.ndarray:
    """
    Return S l / max(p, l) of each episode, (episodes,).

    The shortest path l is the straight one: with obstacles in its way the figure is a lower bound.
    """
    longest = np.maximum(records.path_length, records.straight_path)
    # whoever starts at the goal would divide zero by zero
    return np.where(records.success, records.straight_path / np.maximum(longest, 1e-9), 0.0)


def stalled_time(records: EpisodeRecords) -> np.ndarray:
    """Return how long the robot stood in each episode, s, (episodes,)."""
    distance = np.hypot(records.displacement[..., 0], records.displacement[..., 1])
    stalled = distance < STALLED_SPEED * records.duration  # False behind the end
    return np.where(stalled, records.duration, 0.0).sum(axis=1)


METRICS = (
    Metric(
        name='navigation_time_mean', label='time of successes', heading='time', unit='s', digits=2,
        episode_key='time', places=frozenset(Place),
        measure=lambda records: records.time, average=Average.SUCCESSES, source=FRANCIS,
        formula='simulated time until the goal is reached',
    ),
    Metric(
        name='path_length_mean', label='path of successes', heading='path', unit='m', digits=2,
        episode_key='path_length', places=frozenset({Place.EVALUATION, Place.COMPARISON}),
        measure=lambda records: records.path_length, average=Average.SUCCESSES, source=FRANCIS,
        formula='sum of |x(k+1) - x(k)| over the steps k, x the position of the robot',
    ),
    Metric(
        name='spl', label='success by path length', heading='SPL',
        measure=success_by_path_length, average=Average.EPISODES,
        source='Anderson et al. 2018, On Evaluation of Embodied Navigation Agents',
        formula='S l / max(p, l): S success (1 or 0), p the path driven, l the straight path from '
        'the start to where the goal counts as reached, so that obstacles only lower the figure',
    ),
    Metric(
        name='stalled_time', label='time stood still', heading='stalled', unit='s', digits=2,
        measure=stalled_time, average=Average.EPISODES, source=FRANCIS,
        formula=f'duration of the steps with a mean speed below {STALLED_SPEED:g} m/s',
    ),
)  # fmt: skip
