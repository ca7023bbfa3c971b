"""Comparisons are paired."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.evaluation import compare, evaluate
from socialnav_core.policies import OrcaPolicy, StraightLinePolicy
from socialnav_core.simulation import make_scenario

HARD = make_scenario('hard')


@pytest.fixture(scope='module')
def results():
    policies = {'orca': OrcaPolicy(), 'tight': OrcaPolicy(0.0), 'blind': StraightLinePolicy()}
    return [evaluate(policy, HARD, 60, name=name) for name, policy in policies.items()]


def test_every_pair_is_compared_once(results):
    pairs = [(comparison.first, comparison.second) for comparison in compare(results)]
    assert pairs == [('orca', 'tight'), ('orca', 'blind'), ('tight', 'blind')]


def test_the_difference_is_that_of_the_success_rates(results):
    first, _, second = results
    comparison = compare([first, second])[0]
    expected = first.records.success.mean() - second.records.success.mean()
    assert comparison.success_difference.mean == pytest.approx(expected)
    assert comparison.success_difference.low <= expected <= comparison.success_difference.high


def test_times_are_compared_on_cases_that_both_solved(results):
    first, second, _ = results
    both = first.records.success & second.records.success
    comparison = compare([first, second])[0]
    assert comparison.both_solved == both.sum()
    expected = np.mean(first.records.time[both] - second.records.time[both])
    assert comparison.time_difference.mean == pytest.approx(expected)


def test_a_policy_does_not_differ_from_itself(results):
    comparison = compare([results[0], results[0]])[0]
    assert comparison.mcnemar.p_value == comparison.adjusted_p_value == 1.0
    assert comparison.success_difference.low == comparison.success_difference.high == 0.0


def test_p_values_grow_with_the_number_of_comparisons(results):
    comparisons = compare(results)
    assert all(c.adjusted_p_value >= c.mcnemar.p_value for c in comparisons)
    assert any(c.adjusted_p_value > c.mcnemar.p_value for c in comparisons)


def test_there_is_no_time_difference_where_hardly_a_case_was_solved_by_both(results):
    blind = results[2]
    failing = dataclasses.replace(blind.records, outcome=np.full(60, 5, np.int8))
    comparison = compare([results[0], dataclasses.replace(blind, records=failing)])[0]
    assert comparison.time_difference is None


def test_different_cases_are_not_compared(results):
    other = evaluate(OrcaPolicy(), HARD, 60, seed=1)
    with pytest.raises(ConfigError, match='same cases'):
        compare([results[0], other])
