"""Intervals and tests for success rates, times and their differences between policies."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats


@dataclass(frozen=True)
class Estimate:
    """A mean with the two ends of its confidence interval."""

    mean: float
    low: float
    high: float


@dataclass(frozen=True)
class McNemarResult:
    """The discordant pairs of two policies and the two-sided p-value of their difference."""

    first_only: int
    """Cases that only the first policy solved."""
    second_only: int
    """Cases that only the second policy solved."""
    p_value: float


def wilson_interval(successes: int, n: int, level: float = 0.95) -> tuple[float, float]:
    """
    Return Wilson's score interval of a success rate, without continuity correction.

    Source: Wilson 1927, as computed by `scipy.stats.binomtest`.

    :param level: confidence level between 0 and 1.
    :raises ValueError: when n is zero or successes lies outside 0 to n.
    """
    if n < 1:
        raise ValueError('a success rate needs at least one case, got n = 0: run some episodes')
    interval = stats.binomtest(successes, n).proportion_ci(level, method='wilson')
    return float(interval.low), float(interval.high)


def mcnemar(first: np.ndarray, second: np.ndarray) -> McNemarResult:
    """
    Test with McNemar's exact binomial test whether two policies solve equally many cases.

    Given the pairs in which the outcomes differ, each direction has probability 1/2 under
    the hypothesis of no difference (McNemar 1947, in its exact conditional form).

    :param first: whether the first policy solved each case, bool, shape (cases,).
    :param second: the same for the second policy, on the same cases in the same order.
    :raises ValueError: when the shapes differ.
    """
    first, second = _paired(np.asarray(first, dtype=bool), np.asarray(second, dtype=bool))
    first_only = int(np.sum(first & ~second))
    second_only = int(np.sum(second & ~first))
    discordant = first_only + second_only
    p_value = float(stats.binomtest(first_only, discordant).pvalue) if discordant else 1.0
    return McNemarResult(first_only, second_only, p_value)


def holm(p_values: Sequence[float] | np.ndarray) -> np.ndarray:
    """
    Return p-values adjusted for the number of tests by Holm's step-down method.

    An adjusted value at or below the level rejects its hypothesis while the chance of any
    false rejection stays below that level (Holm 1979).

    :param p_values: shape (tests,).
    :returns: adjusted p-values in the order given, shape (tests,).
    """
    values = np.asarray(p_values, dtype=float)
    order = np.argsort(values, kind='stable')
    scaled = values[order] * np.arange(values.size, 0, -1)
    adjusted = np.empty_like(values)
    adjusted[order] = np.minimum(np.maximum.accumulate(scaled), 1.0)
    return adjusted


def paired_mean_difference(
    first: np.ndarray,
    second: np.ndarray,
    generator: np.random.Generator,
    level: float = 0.95,
    resamples: int = 9999,
) -> Estimate:
    """
    Return the mean of first - second over paired cases with a percentile bootstrap interval.

    :param first: one finite value per case, for instance a time in seconds, shape (cases,).
    :param second: the same for the other policy, on the same cases in the same order.
    :param level: confidence level between 0 and 1.
    :raises ValueError: when the shapes differ, a value is not finite or fewer than 2 cases exist.
    """
    first, second = _paired(np.asarray(first, dtype=float), np.asarray(second, dtype=float))
    difference = first - second
    if difference.size < 2 or not np.all(np.isfinite(difference)):
        raise ValueError('need two or more cases with finite values: keep those both solved')
    interval = stats.bootstrap(
        (difference,),
        np.mean,
        n_resamples=resamples,
        batch=100,  # bounds the memory at 100 resamples of all cases
        confidence_level=level,
        method='percentile',
        rng=generator,
    ).confidence_interval
    return Estimate(float(difference.mean()), float(interval.low), float(interval.high))


def seeds_and_cases_bootstrap(
    values: np.ndarray,
    generator: np.random.Generator,
    level: float = 0.95,
    resamples: int = 2000,
) -> Estimate:
    """
    Return the mean over training seeds and cases with an interval that covers both.

    Every bootstrap sample draws seeds and cases independently and with replacement, and takes
    all their combinations (the "pigeonhole" bootstrap of Owen 2007): every seed met the same
    cases. With one seed the interval speaks of the cases alone. Very few seeds give
    an interval that is too narrow, because few different samples can be drawn from them.

    :param values: outcome or time of each seed and case, or a difference of two policies;
        NaN where there is none (the time of a failure), shape (seeds, cases).
    :param level: confidence level between 0 and 1.
    :raises ValueError: when the array is not two-dimensional or holds no value.
    """
    values = np.asarray(values, dtype=float)
    present = ~np.isnan(values)
    if values.ndim != 2 or not present.any():
        raise ValueError(f'need an array (seeds, cases) with values in it, got {values.shape}')
    seeds, cases = values.shape
    filled = np.where(present, values, 0.0)
    means = np.empty(resamples)
    for sample in range(resamples):
        chosen_seeds = generator.integers(seeds, size=seeds)
        chosen_cases = generator.integers(cases, size=cases)
        total = filled[chosen_seeds].sum(axis=0)[chosen_cases].sum()
        count = present[chosen_seeds].sum(axis=0)[chosen_cases].sum()
        means[sample] = total / count if count else np.nan
    low, high = np.nanquantile(means, [(1 - level) / 2, (1 + level) / 2])
    return Estimate(float(filled.sum() / present.sum()), float(low), float(high))


def _paired(first: np.ndarray, second: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return both arrays after a check that they hold one value for each of the same cases."""
    if first.ndim != 1 or first.shape != second.shape:
        raise ValueError(
            f'paired values need one shape (cases,), got {first.shape} and {second.shape}: '
            'evaluate both policies on the same cases'
        )
    return first, second
