"""A figure of the report against ours."""

from founding_report.report_figures import CASES
from socialnav_core.evaluation.statistics import wilson_interval

ROUNDING = 1e-9


def rate_verdict(reported: float, ours: float, more_is_better: bool) -> str:
    """
    Return whether a rate is as good as the report's.

    :param reported: rate over the report's 500 cases.
    :param ours: our mean over seeds.
    :param more_is_better: true of successes, false of collisions.
    """
    low, high = reported_interval(reported)
    lead = (ours - reported) * (1 if more_is_better else -1)
    if lead >= -ROUNDING:
        return 'at or above the report' if more_is_better else 'at or below the report'
    if low <= ours <= high:
        return f'inside its interval [{low:.3f}, {high:.3f}]'
    return f'missed by {-lead:.3f}'


def time_verdict(reported: float, ours: float | None) -> str:
    """
    Return how much faster a mean time is than the report's, which has no interval.

    :param ours: our mean over the successes of all seeds, s; None without successes.
    """
    if ours is None:
        return 'no success'
    return f'{abs(ours - reported):.2f} s {"faster" if ours <= reported else "slower"}'


def reported_interval(reported: float) -> tuple[float, float]:
    """Return Wilson's interval of a rate over the report's 500 cases."""
    return wilson_interval(round(reported * CASES), CASES)
