"""Results as text."""

from collections.abc import Iterable, Sequence

from socialnav_core.config.scenarios import title_of
from socialnav_core.evaluation.comparison import Comparison
from socialnav_core.evaluation.run import EvaluationResult
from socialnav_core.evaluation.statistics import Estimate
from socialnav_core.metrics import Metric, Place, shown_in
from socialnav_core.tables import NOTHING, number, text_table

WITH_INTERVAL = ('success_rate', 'collision_rate', 'timeout_rate', 'solvable_success_rate')
"""Rates that are printed with their intervals where there is a line for each figure."""
IN_COLUMNS = ('success_rate', 'solvable_success_rate')
"""Rates that are printed with their intervals where there is a column for each figure."""
COMPARISON_COLUMNS = (
    'first', 'second', 'success', 'only one solved', 'p (Holm)', 'time, both solved',
)  # fmt: skip


def evaluation_text(result: EvaluationResult, further: Iterable[str] = ()) -> str:
    """
    Return the figures of one policy, a line each.

    :param further: names of metrics besides those that are always shown, or `all`.
    """
    summary = result.summary(further)
    rows = [
        (metric.label, figure_text(result, metric, summary[metric.name], WITH_INTERVAL))
        for metric in shown_in(Place.EVALUATION, summary)
    ]
    rows.append(('decisions per second', f'{result.decisions_per_second:,.0f}'))
    width = max(len(label) for label, _ in rows)
    lines = [f'{label:<{width}}  {value}' for label, value in rows]
    return '\n'.join([title(result), '', *lines])


def comparison_text(
    results: Sequence[EvaluationResult],
    comparisons: Sequence[Comparison],
    further: Iterable[str] = (),
) -> str:
    """
    Return the figures of some policies and their differences as two tables.

    :param results: on the same cases.
    :param further: names of metrics besides those that are always shown, or `all`.
    """
    differences = [COMPARISON_COLUMNS, *map(comparison_row, comparisons)]
    first = results[0]
    world = title_of(first.scenario, first.changes)
    return '\n'.join(
        [
            f'{world}: {first.episodes} cases of {first.split}, seed {first.seed}',
            '',
            text_table(overview(results, further)),
            '',
            "Differences, first - second, with 95 % intervals; p by McNemar's exact test:",
            '',
            text_table(differences),
        ]
    )


def overview(results: Sequence[EvaluationResult], further: Iterable[str]) -> list[tuple[str, ...]]:
    """Return the names of the columns and a row of figures for each result."""
    summaries = [result.summary(further) for result in results]
    metrics = shown_in(Place.COMPARISON, summaries[0])
    rows = [
        (
            result.model,
            result.policy.look_ahead or NOTHING,
            *(figure_text(result, metric, summary[metric.name], IN_COLUMNS) for metric in metrics),
        )
        for result, summary in zip(results, summaries, strict=True)
    ]
    return [('model', 'look-ahead', *(metric.column for metric in metrics)), *rows]


def figure_text(
    result: EvaluationResult, metric: Metric, value: float | None, with_interval: Iterable[str]
) -> str:
    """
    Return the figure of a metric.

    :param with_interval: names of the rates that are followed by their interval.
    """
    if metric.name in with_interval and value is not None:
        return rate_text(value, result.interval(metric.name))
    return metric.text(value)


def comparison_row(comparison: Comparison) -> tuple[str, ...]:
    """Return the cells of COMPARISON_COLUMNS for one pair of policies."""
    return (
        comparison.first,
        comparison.second,
        estimate_text(comparison.success_difference, 3),
        f'{comparison.mcnemar.first_only} : {comparison.mcnemar.second_only}',
        f'{comparison.adjusted_p_value:.2g}',
        estimate_text(comparison.time_difference, 2, 's'),
    )


def title(result: EvaluationResult) -> str:
    """Return what was evaluated, on one line."""
    policy = result.policy
    cases = f'{result.episodes} cases of {result.split}, seed {result.seed}'
    how = (
        f', look-ahead {policy.look_ahead}, screening {"on" if policy.screening else "off"}'
        if policy.look_ahead
        else ''
    )
    return f'{result.model} in {title_of(result.scenario, result.changes)}: {cases}{how}'


def rate_text(rate: float, interval: Sequence[float], digits: int = 3) -> str:
    """Return a rate with its interval."""
    low, high = (number(end, digits) for end in interval)
    return f'{number(rate, digits)} [{low}, {high}]'


def estimate_text(estimate: Estimate | None, digits: int, unit: str = '') -> str:
    """
    Return a difference with its interval.

    :param estimate: None where there is nothing to compare.
    :param digits: after the point.
    :param unit: what follows the mean after a space.
    """
    if estimate is None:
        return NOTHING
    low, high = f'{estimate.low:+.{digits}f}', f'{estimate.high:+.{digits}f}'
    unit = f' {unit}' if unit else ''
    return f'{estimate.mean:+.{digits}f}{unit} [{low}, {high}]'
