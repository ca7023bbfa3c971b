"""The figures as rows of text, a column for each policy."""

from collections.abc import Sequence

import numpy as np

from socialnav_core.evaluation import EvaluationResult
from socialnav_core.evaluation.report import COMPARISON_COLUMNS, comparison_row, figure_text
from socialnav_core.metrics import EVERY, Metric, METRICS
from socialnav_core.tables import NOTHING
from socialnav_core.viewing.recording import OUTCOMES
from socialnav_core.viewing.report.contents import OUTCOME_NAMES, World

MAIN = (
    'success_rate', 'collision_rate', 'timeout_rate', 'navigation_time_mean', 'path_length_mean',
    'minimum_people_distance', 'intrusion_rate',
)  # fmt: skip
"""Metrics of the first table; the second one has all."""
RATES = (
    'success_rate', 'collision_rate', 'collision_pedestrian_rate', 'collision_obstacle_rate',
    'out_of_bounds_rate', 'timeout_rate',
)  # fmt: skip
"""Metrics that are true or false in each case, and so have an interval."""
Row = tuple[str, ...]


def main_rows(results: Sequence[EvaluationResult]) -> list[Row]:
    """Return what it is, then the figure of each policy, for each metric of MAIN."""
    look_ahead = ('prediction', *(result.policy.look_ahead or NOTHING for result in results))
    speeds = (f'{result.decisions_per_second:,.0f}' for result in results)
    return [*rows_of(results, [METRICS[name] for name in MAIN]),
            ('decisions per second', *speeds), look_ahead]  # fmt: skip


def all_rows(results: Sequence[EvaluationResult]) -> list[Row]:
    """Return the same for each metric of which any policy has a figure, and how it is defined."""
    measured = [result.summary([EVERY]) for result in results]
    metrics = [
        metric
        for metric in METRICS.values()
        if any(figures[metric.name] is not None for figures in measured)
    ]
    rows = rows_of(results, metrics)
    return [(*row, metric.formula) for row, metric in zip(rows, metrics, strict=True)]


def rows_of(results: Sequence[EvaluationResult], metrics: Sequence[Metric]) -> list[Row]:
    """Return what it is, then the figure of each policy, for each metric."""
    figures = [(result, result.summary([EVERY])) for result in results]
    return [
        (
            f'… {metric.label.strip()}' if metric.label.startswith(' ') else metric.label,
            *(figure_text(result, metric, each[metric.name], RATES) for result, each in figures),
        )
        for metric in metrics
    ]


def comparison_rows(world: World) -> list[Row]:
    """Return the names of the columns and a row for each pair of policies."""
    return [COMPARISON_COLUMNS, *map(comparison_row, world.comparisons)]


def unseen_failures(world: World, result: EvaluationResult) -> list[tuple[str, str]]:
    """Return how cases ended that failed and cannot be played, and their numbers."""
    records = result.records
    unseen = ~np.isin(records.case_index, world.played)
    found = [
        (name, records.case_index[unseen & (records.outcome == code)])
        for code, name in enumerate(OUTCOME_NAMES)
        if name in OUTCOMES and name != 'goal'
    ]
    return [(OUTCOMES[name], ', '.join(map(str, cases))) for name, cases in found if len(cases)]
