"""Laws of the intervals and tests, most of them against published values."""

import numpy as np
import pytest

from socialnav_core.evaluation.statistics import (
    Estimate,
    holm,
    mcnemar,
    paired_mean_difference,
    seeds_and_cases_bootstrap,
    wilson_interval,
)


@pytest.fixture
def generator() -> np.random.Generator:
    return np.random.default_rng(0)


def _pairs(both: int, first_only: int, second_only: int, neither: int) -> list[np.ndarray]:
    counts = [both, first_only, second_only, neither]
    return [np.repeat(row, counts) for row in ([1, 1, 0, 0], [1, 0, 1, 0])]


@pytest.mark.parametrize(
    ('successes', 'n', 'low', 'high'),
    [
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0000, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_wilson_interval_gives_the_values_of_newcombe_1998_table_1(successes, n, low, high):
    assert wilson_interval(successes, n) == pytest.approx((low, high), abs=5e-5)


def test_wilson_interval_widens_with_the_level():
    low, high = wilson_interval(90, 100, level=0.95)
    wide_low, wide_high = wilson_interval(90, 100, level=0.99)
    assert wide_low < low < 0.9 < high < wide_high


def test_wilson_interval_of_no_cases_is_an_error():
    with pytest.raises(ValueError, match='at least one case'):
        wilson_interval(0, 0)


@pytest.mark.parametrize(
    ('table', 'p_value'),
    [((1, 1, 7, 12), 0.0703), ((59, 6, 16, 80), 0.0525)],
)
def test_mcnemar_gives_the_exact_values_of_fagerland_2013(table, p_value):
    result = mcnemar(*_pairs(*table))
    assert (result.first_only, result.second_only) == table[1:3]
    assert result.p_value == pytest.approx(p_value, abs=5e-5)


def test_mcnemar_does_not_depend_on_the_order_of_the_policies():
    first, second = _pairs(5, 2, 9, 4)
    assert mcnemar(first, second).p_value == mcnemar(second, first).p_value


def test_mcnemar_of_equal_outcomes_is_one():
    solved = np.array([True, False, True])
    assert mcnemar(solved, solved).p_value == 1.0


def test_mcnemar_of_different_cases_is_an_error():
    with pytest.raises(ValueError, match='same cases'):
        mcnemar(np.ones(3, dtype=bool), np.ones(4, dtype=bool))


def test_holm_scales_the_smallest_most_and_never_reverses_the_order():
    # Worked example: 4 x .005, 3 x .01, 2 x .03, then max(1 x .04, .06).
    assert holm([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])


def test_holm_never_exceeds_one():
    assert holm([0.9, 0.6, 0.8]) == pytest.approx([1.0, 1.0, 1.0])


def test_paired_difference_of_students_sleep_data_is_1_58_hours(generator):
    # Student 1908: extra hours of sleep of ten patients under two drugs.
    first = np.array([0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0])
    second = np.array([1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4])
    estimate = paired_mean_difference(second, first, generator)
    plug_in_error = np.std(second - first) / np.sqrt(10)
    assert estimate.mean == pytest.approx(1.58)
    assert estimate.high - estimate.low == pytest.approx(2 * 1.96 * plug_in_error, rel=0.1)


def test_paired_difference_ignores_what_both_policies_share(generator):
    difficulty = generator.normal(10.0, 5.0, size=200)
    estimate = paired_mean_difference(difficulty + 0.5, difficulty, generator)
    assert (estimate.mean, estimate.low, estimate.high) == pytest.approx((0.5, 0.5, 0.5))


def test_paired_difference_with_unsolved_cases_is_an_error(generator):
    with pytest.raises(ValueError, match='keep those both solved'):
        paired_mean_difference(np.array([1.0, np.nan]), np.array([1.0, 2.0]), generator)


def test_same_generator_seed_gives_the_same_interval():
    values = np.random.default_rng(1).random((4, 50))
    intervals = [seeds_and_cases_bootstrap(values, np.random.default_rng(7)) for _ in range(2)]
    assert intervals[0] == intervals[1]


def test_bootstrap_interval_over_seeds_covers_a_spread_that_lies_between_seeds_alone(generator):
    seed_means = np.linspace(0.0, 1.0, 10)
    values = np.repeat(seed_means[:, None], 300, axis=1)
    estimate = seeds_and_cases_bootstrap(values, generator)
    expected = 2 * 1.96 * np.std(seed_means) / np.sqrt(10)
    assert estimate.high - estimate.low == pytest.approx(expected, rel=0.1)


def test_bootstrap_interval_covers_a_spread_that_lies_between_cases_alone(generator):
    case_values = generator.normal(size=400)
    estimate = seeds_and_cases_bootstrap(np.tile(case_values, (5, 1)), generator)
    expected = 2 * 1.96 * np.std(case_values) / np.sqrt(400)
    assert estimate.high - estimate.low == pytest.approx(expected, rel=0.1)


def test_bootstrap_interval_holds_the_true_mean_about_as_often_as_its_level_says(generator):
    hits = 0
    for _ in range(200):
        seeds = generator.normal(size=(20, 1))
        cases = generator.normal(size=(1, 30))
        estimate = seeds_and_cases_bootstrap(seeds + cases, generator, resamples=200)
        hits += estimate.low <= 0.0 <= estimate.high
    assert 0.85 <= hits / 200 <= 0.99


def test_bootstrap_leaves_missing_values_out_of_the_mean(generator):
    values = np.array([[10.0, np.nan, 10.0], [10.0, 10.0, np.nan]])
    assert seeds_and_cases_bootstrap(values, generator) == Estimate(10.0, 10.0, 10.0)


def test_bootstrap_of_nothing_is_an_error(generator):
    with pytest.raises(ValueError, match='with values in it'):
        seeds_and_cases_bootstrap(np.full((2, 3), np.nan), generator)
