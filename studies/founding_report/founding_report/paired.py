"""Two rows on the same cases: whether one is better than the other."""

from collections.abc import Sequence
import dataclasses
from typing import Any

import numpy as np

from founding_report.summary import Summary
from socialnav_core.evaluation.statistics import (
    Estimate,
    holm,
    mcnemar,
    McNemarResult,
    seeds_and_cases_bootstrap,
)


@dataclasses.dataclass(frozen=True)
class PairedDifference:
    """The difference first - second of two rows in one scenario with one look-ahead."""

    first: Summary
    second: Summary
    success: Estimate
    """Difference of the success rates; bootstrap over seeds and cases."""
    time: Estimate | None
    """The same of the times where both succeeded, s; None where that never happened."""
    tests: tuple[McNemarResult, ...]
    """McNemar's test of each seed that both have."""
    adjusted: tuple[float, ...] = ()
    """Their p-values, adjusted by Holm's method for all tests of the page."""

    @property
    def pooled(self) -> tuple[int, int]:
        """Return how many pairs of seed and case only the first solved, and only the second."""
        return (
            sum(test.first_only for test in self.tests),
            sum(test.second_only for test in self.tests),
        )

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain values, fit for JSON."""
        return {
            'first': self.first.row.name,
            'second': self.second.row.name,
            'scenario': self.first.scenario,
            'lookahead': self.first.lookahead,
            'success_difference': dataclasses.asdict(self.success),
            'time_difference': dataclasses.asdict(self.time) if self.time else None,
            'tests': [dataclasses.asdict(test) for test in self.tests],
            'adjusted_p_values': list(self.adjusted),
        }


def paired_differences(
    summaries: Sequence[Summary], pairs: Sequence[tuple[str, str]]
) -> list[PairedDifference]:
    """
    Return the differences of pairs of rows in all scenarios that both are tested in.

    :param pairs: names of rows, the second one subtracted from the first.
    """
    by_name = {each.key: each for each in summaries}
    found = [
        paired_difference(summary, by_name[second, summary.scenario, summary.lookahead])
        for first, second in pairs
        for (name, *where), summary in by_name.items()
        if name == first and (second, *where) in by_name
    ]
    values = [test.p_value for difference in found for test in difference.tests]
    adjusted = iter(holm(values).tolist()) if values else iter(())
    return [
        dataclasses.replace(each, adjusted=tuple(next(adjusted) for _ in each.tests))
        for each in found
    ]


def paired_difference(first: Summary, second: Summary) -> PairedDifference:
    """Return the difference of two rows in the same cases over the seeds that both have."""
    count = min(len(first.seeds), len(second.seeds))
    one, other = (each.values('success')[:count] for each in (first, second))
    times = first.values('time')[:count] - second.values('time')[:count]
    generator = np.random.default_rng(0)
    return PairedDifference(
        first,
        second,
        seeds_and_cases_bootstrap(one - other, generator),
        None if np.isnan(times).all() else seeds_and_cases_bootstrap(times, generator),
        tuple(mcnemar(a == 1, b == 1) for a, b in zip(one, other, strict=True)),
    )
