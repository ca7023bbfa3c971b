"""Two or more policies on the same cases: what differs, and whether it could be chance."""

from collections.abc import Sequence
import dataclasses
import itertools
from typing import Any

import numpy as np

from socialnav_core.config import ConfigError
from socialnav_core.evaluation.run import EvaluationResult
from socialnav_core.evaluation.statistics import (
    Estimate,
    holm,
    mcnemar,
    McNemarResult,
    paired_mean_difference,
)

RESAMPLES = 4999


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Differences between two policies, first - second, over the same cases."""

    first: str
    """Name of the first policy."""
    second: str
    """Name of the second policy."""
    success_difference: Estimate
    """Difference of the success rates, 95 % bootstrap interval over cases."""
    mcnemar: McNemarResult
    """Cases that only one of them solved, and the probability of such a difference by chance."""
    adjusted_p_value: float
    """The same probability, adjusted for the number of comparisons (Holm)."""
    both_solved: int
    """Cases that both solved."""
    time_difference: Estimate | None
    """Difference of the times on those, s; None when there are fewer than two."""

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain values, fit for JSON."""
        values = dataclasses.asdict(self)
        return values.pop('mcnemar') | values


def compare(results: Sequence[EvaluationResult]) -> list[Comparison]:
    """
    Return the comparison of every pair of policies.

    :param results: at least two, of the same cases.
    :raises ConfigError: when the cases are not the same.
    """
    cases = {(r.scenario, str(r.changes), r.seed, r.split, r.episodes) for r in results}
    if len(results) < 2 or len(cases) != 1:
        raise ConfigError('a comparison needs two or more policies on the same cases')
    pairs = list(itertools.combinations(results, 2))
    tests = [mcnemar(first.records.success, second.records.success) for first, second in pairs]
    adjusted = holm([test.p_value for test in tests])
    return [
        Comparison(
            first.model, second.model, _success_difference(first, second), test, float(p_value),
            int((first.records.success & second.records.success).sum()),
            _time_difference(first, second),
        )
        for (first, second), test, p_value in zip(pairs, tests, adjusted, strict=True)
    ]  # fmt: skip


def _success_difference(first: EvaluationResult, second: EvaluationResult) -> Estimate:
    """Return the difference of the success rates."""
    one, other = (result.records.success.astype(float) for result in (first, second))
    if len(one) < 2:
        difference = float(one.mean() - other.mean())
        return Estimate(difference, -1.0, 1.0)
    return paired_mean_difference(one, other, np.random.default_rng(0), resamples=RESAMPLES)


def _time_difference(first: EvaluationResult, second: EvaluationResult) -> Estimate | None:
    """Return the difference of the times on the cases that both solved."""
    both = first.records.success & second.records.success
    if both.sum() < 2:
        return None
    one, other = first.records.time[both], second.records.time[both]
    return paired_mean_difference(one, other, np.random.default_rng(0), resamples=RESAMPLES)
