"""Results as text."""

from collections.abc import Sequence

from socialnav_core.evaluation.comparison import Comparison
from socialnav_core.evaluation.run import EvaluationResult
from socialnav_core.evaluation.statistics import Estimate, wilson_interval

NOTHING = '-'


def evaluation_text(result: EvaluationResult) -> str:
    """
    Return the figures of one policy, a line each.

    :param result: of evaluate.
    """
    summary = result.summary()
    rows = [
        ('success', rate_text(summary['success_rate'], result.episodes)),
        ('collision', rate_text(summary['collision_rate'], result.episodes)),
        ('  with a pedestrian', number(summary['collision_pedestrian_rate'], 3)),
        ('  with an obstacle', number(summary['collision_obstacle_rate'], 3)),
        ('  out of bounds', number(summary['out_of_bounds_rate'], 3)),
        ('time-out', rate_text(summary['timeout_rate'], result.episodes)),
        ('time of successes', number(summary['navigation_time_mean'], 2, ' s')),
        ('path of successes', number(summary['path_length_mean'], 2, ' m')),
        ('least clearance, mean', number(summary['minimum_clearance_mean'], 2, ' m')),
        ('steps within 0.2 m of people', number(summary['intrusion_rate'], 3)),
        ('decisions per second', f'{result.decisions_per_second:,.0f}'),
    ]
    width = max(len(label) for label, _ in rows)
    lines = [f'{label:<{width}}  {value}' for label, value in rows]
    return '\n'.join([title(result), '', *lines])


def comparison_text(results: Sequence[EvaluationResult], comparisons: Sequence[Comparison]) -> str:
    """
    Return the figures of some policies and their differences as two tables.

    :param results: of evaluate, on the same cases.
    :param comparisons: of compare.
    """
    differences: list[tuple[str, ...]] = [COMPARISON_COLUMNS]
    differences += [comparison_row(comparison) for comparison in comparisons]
    overview: list[tuple[str, ...]] = [RESULT_COLUMNS]
    overview += [result_row(result) for result in results]
    first = results[0]
    return '\n'.join(
        [
            f'{first.scenario}: {first.episodes} cases of {first.split}, seed {first.seed}',
            '',
            table(overview),
            '',
            "Differences, first - second, with 95 % intervals; p by McNemar's exact test:",
            '',
            table(differences),
        ]
    )


COMPARISON_COLUMNS = (
    'first',
    'second',
    'success',
    'only one solved',
    'p (Holm)',
    'time, both solved',
)
RESULT_COLUMNS = (
    'model', 'look-ahead', 'success', 'collision', 'time-out', 'time', 'path', 'intrusion',
)  # fmt: skip


def result_row(result: EvaluationResult) -> tuple[str, ...]:
    """
    Return the cells of RESULT_COLUMNS.

    :param result: of evaluate.
    """
    summary = result.summary()
    return (
        result.model,
        result.policy.look_ahead or NOTHING,
        rate_text(summary['success_rate'], result.episodes),
        number(summary['collision_rate'], 3),
        number(summary['timeout_rate'], 3),
        number(summary['navigation_time_mean'], 2, ' s'),
        number(summary['path_length_mean'], 2, ' m'),
        number(summary['intrusion_rate'], 3),
    )


def comparison_row(comparison: Comparison) -> tuple[str, ...]:
    """
    Return the cells of one pair of policies.

    :param comparison: of compare.
    """
    return (
        comparison.first,
        comparison.second,
        estimate_text(comparison.success_difference, 3),
        f'{comparison.mcnemar.first_only} : {comparison.mcnemar.second_only}',
        f'{comparison.adjusted_p_value:.2g}',
        estimate_text(comparison.time_difference, 2, ' s'),
    )


def title(result: EvaluationResult) -> str:
    """
    Return what was evaluated, on one line.

    :param result: of evaluate.
    """
    policy = result.policy
    cases = f'{result.episodes} cases of {result.split}, seed {result.seed}'
    how = (
        f', look-ahead {policy.look_ahead}, screening {"on" if policy.screening else "off"}'
        if policy.look_ahead
        else ''
    )
    return f'{result.model} in {result.scenario}: {cases}{how}'


def rate_text(rate: float | None, episodes: int) -> str:
    """
    Return a rate with its Wilson interval.

    :param rate: share of the episodes.
    :param episodes: number of them.
    """
    if rate is None:
        return NOTHING
    low, high = wilson_interval(round(rate * episodes), episodes)
    return f'{rate:.3f} [{low:.3f}, {high:.3f}]'


def estimate_text(estimate: Estimate | None, digits: int, unit: str = '') -> str:
    """
    Return a difference with its interval.

    :param estimate: None where there is nothing to compare.
    :param digits: after the point.
    :param unit: what follows the mean.
    """
    if estimate is None:
        return NOTHING
    low, high = f'{estimate.low:+.{digits}f}', f'{estimate.high:+.{digits}f}'
    return f'{estimate.mean:+.{digits}f}{unit} [{low}, {high}]'


def number(value: float | None, digits: int, unit: str = '') -> str:
    """
    Return a number as text, a dash for None.

    :param value: the number.
    :param digits: after the point.
    :param unit: what follows it.
    """
    return NOTHING if value is None else f'{value:.{digits}f}{unit}'


def table(rows: Sequence[tuple[str, ...]]) -> str:
    """
    Return rows as text in columns, the first row underlined.

    :param rows: cells, as many in each row.
    """
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = ['  '.join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return '\n'.join([lines[0], '  '.join('-' * width for width in widths), *lines[1:]])
