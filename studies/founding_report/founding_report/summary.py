"""Figures of a row over its training seeds."""

from collections.abc import Callable
import dataclasses

import numpy as np

from founding_report.experiments import Entry
from founding_report.laboratory import Laboratory
from founding_report.measurements import Cases, Measurement
from founding_report.rows import Row
from socialnav_core.evaluation.statistics import Estimate, seeds_and_cases_bootstrap

FIGURES: dict[str, Callable[[Measurement], np.ndarray]] = {
    'success': lambda measurement: measurement.success,
    'collision': lambda measurement: measurement.collision,
    'timeout': lambda measurement: measurement.timeout,
    'time': lambda measurement: measurement.navigation_time,
}
"""Figures by name; each gives a value per case, NaN where it has none."""


@dataclasses.dataclass(frozen=True)
class Summary:
    """One row in one scenario with one look-ahead, over its seeds."""

    row: Row
    scenario: str
    lookahead: str
    seeds: tuple[int, ...]
    """Training seeds."""
    measurements: tuple[Measurement, ...]
    """One for each seed, of the same cases."""

    @property
    def key(self) -> tuple[str, str, str]:
        """Return the names of the row, the scenario and the look-ahead."""
        return self.row.name, self.scenario, self.lookahead

    def values(self, figure: str) -> np.ndarray:
        """
        Return a figure of each seed and case, NaN where it has none, (seeds, cases).

        :param figure: a key of FIGURES.
        """
        return np.array([FIGURES[figure](each) for each in self.measurements], float)

    def estimate(self, figure: str) -> Estimate | None:
        """
        Return a mean over seeds and cases with its bootstrap interval; None of no values.

        :param figure: a key of FIGURES.
        """
        values = self.values(figure)
        if np.isnan(values).all():
            return None
        return seeds_and_cases_bootstrap(values, np.random.default_rng(0))

    def mean(self, figure: str) -> float | None:
        """
        Return a mean over seeds and cases; None of no values.

        :param figure: a key of FIGURES.
        """
        values = self.values(figure)
        return None if np.isnan(values).all() else float(np.nanmean(values))


def seed_interval(measurement: Measurement) -> tuple[float, float]:
    """Return Wilson's interval of the success rate of one seed."""
    low, high = measurement.summary['success_interval']
    return low, high


def summarise(entry: Entry, laboratory: Laboratory) -> list[Summary]:
    """Return the figures of a row in every scenario that it is tested in, look-aheads together."""
    seeds = tuple(range(entry.seeds))
    return [summary_of(entry.row, cases, seeds, laboratory) for cases in entry.cases(laboratory)]


def summary_of(row: Row, cases: Cases, seeds: tuple[int, ...], laboratory: Laboratory) -> Summary:
    """Return the figures of a row in some cases."""
    found = tuple(laboratory.measurement(row, seed, cases) for seed in seeds)
    return Summary(row, cases.scenario, cases.lookahead, seeds, found)
