"""Metrics against what could have been done: see `evaluation/bound.py`."""

import numpy as np

from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import Average, Metric

SOURCE = 'this project: docs/bound.md'


def solvable(records: EpisodeRecords) -> np.ndarray:
    """Return 1 where a path is known, 0 where none was found, NaN without a bound, (episodes,)."""
    return np.where(np.isnan(records.bound), np.nan, np.isfinite(records.bound))


def solved_where_solvable(records: EpisodeRecords) -> np.ndarray:
    """Return whether each solvable episode succeeded, NaN in the others, (episodes,)."""
    return np.where(np.isfinite(records.bound), records.success, np.nan)


METRICS = (
    Metric(
        name='solvable_rate', label='cases with a known solution', heading='solvable',
        measure=solvable, average=Average.EPISODES, source=SOURCE,
        formula='share of cases for which the clairvoyant search finds a path in time',
    ),
    Metric(
        name='solvable_success_rate', label='success in these', heading='success where solvable',
        measure=solved_where_solvable, average=Average.EPISODES, source=SOURCE,
        formula='share of the cases with a known solution in which the robot reaches the goal',
    ),
    Metric(
        name='time_over_bound', label='time over the bound', heading='over bound', unit='s',
        digits=2, average=Average.SUCCESSES, source=SOURCE,
        measure=lambda records: records.time - records.bound,
        formula='T - T*: T the time of the robot, T* that of the fastest path that the '
        'clairvoyant search finds',
    ),
    Metric(
        name='time_over_comfortable_bound', label='time over the comfortable bound',
        heading='over comfortable', unit='s', digits=2, average=Average.SUCCESSES, source=SOURCE,
        measure=lambda records: records.time - records.comfortable_bound,
        formula='the same for the fastest path that keeps 0.2 m of people throughout',
    ),
)  # fmt: skip
