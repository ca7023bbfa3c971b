"""Measurements belong to weights, and their figures to all seeds and cases."""

import dataclasses
import functools

import numpy as np
import pytest

from founding_report import measurements
from founding_report.experiments import Entry, EXPERIMENTS
from founding_report.measurements import Cases, Measurement
from founding_report.page import paired, seeds_won
from founding_report.paired import paired_differences
from founding_report.rows import ROWS
from founding_report.summary import Summary, summary_of
from socialnav_core.evaluation.statistics import McNemarResult, seeds_and_cases_bootstrap
from socialnav_core.simulation import Outcome

HARD = Cases('hard', 'constant_velocity')
SARL, GAT4SN = ROWS['sarl'], ROWS['gat4sn']


def test_a_measurement_is_kept_as_it_was_made(finished_run, measured):
    folder = finished_run(SARL, 0)
    measured(folder, HARD, ['goal', 'timeout', 'out_of_bounds', 'collision_obstacle'])
    found = measurements.load(folder, HARD)
    np.testing.assert_array_equal(found.success, [True, False, False, False])
    np.testing.assert_array_equal(found.collision, [False, False, True, True])
    np.testing.assert_array_equal(found.timeout, [False, True, False, False])
    np.testing.assert_array_equal(found.navigation_time, [10, np.nan, np.nan, np.nan])


def test_a_measurement_of_other_weights_does_not_count(finished_run, measured):
    folder = finished_run(SARL, 0)
    measured(folder, HARD, ['goal'])
    finished_run(SARL, 0)  # fresh weights
    assert measurements.load(folder, HARD) is None


def test_other_cases_have_another_file(finished_run):
    folder = finished_run(SARL, 0)
    kinds = (HARD, Cases('hard', 'oracle'), Cases('hard', HARD.lookahead, 'validation'),
             Cases('hard', HARD.lookahead, episodes=5000))  # fmt: skip
    assert len({cases.path(folder) for cases in kinds}) == len(kinds)
    assert HARD.path(folder).name == 'hard-constant_velocity.json'


@pytest.fixture
def two_rows(finished_run, measured, laboratory):
    """Return the figures of SARL (2 seeds) and GAT4SN (3 seeds) in the same four cases."""
    outcomes = [(SARL, ['gtgt', 'ggtt']), (GAT4SN, ['gggt', 'gggg', 'tttt'])]
    letters = {'g': 'goal', 't': 'timeout'}
    for row, seeds in outcomes:
        for seed, text in enumerate(seeds):
            folder = finished_run(row, seed)
            measured(folder, HARD, [letters[letter] for letter in text], time=10.0 + len(seeds))
    return [summary_of(row, HARD, tuple(range(len(seeds))), laboratory) for row, seeds in outcomes]


def made_up(experiment, laboratory):
    """Return figures of all rows of an experiment: of two cases, the first one is solved."""
    return [
        Summary(
            entry.row, cases.scenario, cases.lookahead, tuple(range(entry.seeds)),
            (Measurement(cases, np.array([Outcome.GOAL, Outcome.TIMEOUT]), np.ones(2), {}),)
            * entry.seeds,
        )
        for entry in experiment.entries
        for cases in entry.cases(laboratory)
    ]  # fmt: skip


def test_means_are_over_all_seeds_and_cases(two_rows):
    sarl, gat4sn = two_rows
    assert sarl.mean('success') == 0.5
    assert gat4sn.mean('success') == pytest.approx(7 / 12)
    assert gat4sn.mean('time') == 13.0
    estimate = gat4sn.estimate('success')
    assert 0 <= estimate.low < estimate.mean < estimate.high <= 1


def test_pairs_are_compared_over_common_seeds_on_the_same_cases(two_rows):
    (difference,) = paired_differences(two_rows, [('gat4sn', 'sarl')])
    assert difference.success.mean == pytest.approx(7 / 8 - 1 / 2)
    assert difference.pooled == (3, 0)
    assert len(difference.tests) == len(difference.adjusted) == 2
    assert difference.time.mean == pytest.approx(1.0)


@pytest.mark.parametrize('name', [name for name, each in EXPERIMENTS.items() if each.pairs])
def test_every_pair_of_an_experiment_is_compared_where_both_were_tested(
    name, laboratory, monkeypatch
):
    quick = functools.partial(seeds_and_cases_bootstrap, resamples=20)
    monkeypatch.setattr('founding_report.paired.seeds_and_cases_bootstrap', quick)
    experiment = EXPERIMENTS[name]
    summaries = made_up(experiment, laboratory)
    differences = paired_differences(summaries, experiment.pairs)
    found = [(d.first.row.name, d.second.row.name) for d in differences]
    assert set(found) == set(experiment.pairs)
    assert all(d.first.key[1:] == d.second.key[1:] for d in differences)
    assert paired(differences).count('\n| ') == len(differences) + 1


def test_adjusted_probabilities_are_never_smaller(two_rows):
    (difference,) = paired_differences(two_rows, [('gat4sn', 'sarl')])
    assert [test.p_value for test in difference.tests] == [1.0, 0.5]
    assert difference.adjusted == (1.0, 1.0)


def test_only_seeds_whose_difference_is_significant_count_as_such(two_rows):
    (difference,) = paired_differences(two_rows, [('gat4sn', 'sarl')])
    one_way, no_way = McNemarResult(9, 1, 0.01), McNemarResult(3, 2, 1.0)
    other_way = McNemarResult(1, 9, 0.01)
    difference = dataclasses.replace(
        difference, tests=(one_way, no_way, other_way, other_way), adjusted=(0.04, 1, 0.04, 0.04)
    )
    assert seeds_won(difference) == '2 : 2'
    assert seeds_won(difference, 0.05) == '1 : 2'


def test_a_row_with_one_seed_meets_one_seed_and_the_page_says_so(two_rows, laboratory):
    alone = summary_of(SARL, HARD, (0,), laboratory)
    differences = paired_differences([alone, two_rows[1]], [('gat4sn', 'sarl')])
    text = paired(differences)
    assert '| `hard` | constant velocity | 1 | +0.250' in text
    assert 'with one seed: over cases alone' in text


def test_a_row_without_successes_has_no_time(finished_run, measured, laboratory):
    measured(finished_run(SARL, 0), HARD, ['timeout'] * 3)
    summary = summary_of(SARL, HARD, (0,), laboratory)
    assert summary.estimate('time') is None
    assert summary.mean('success') == 0.0


def test_an_entry_may_be_tested_elsewhere(laboratory):
    entry = Entry(SARL, 1, ('packed-2.5',))
    assert {cases.scenario for cases in entry.cases(laboratory)} == {'packed-2.5'}
    assert {cases.scenario for cases in Entry(SARL, 1).cases(laboratory)} == set(SARL.tests)
