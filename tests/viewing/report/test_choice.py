"""Laws of the cases that the page plays."""

from made_report import made_results
import numpy as np
import pytest

from socialnav_core.simulation import make_scenario
from socialnav_core.viewing.report.choice import (
    cases_per_world,
    chosen_cases,
    failures,
    solved_by_all,
)


@pytest.fixture(scope='module')
def results():
    return made_results(make_scenario('simple'), 24)


def test_a_page_of_many_policies_and_worlds_plays_fewer_cases_of_each():
    assert cases_per_world(2, 2) == 8
    assert 2 * 5 * 4 <= cases_per_world(5, 4) * 5 * 4 < cases_per_world(2, 2) * 5 * 4


def test_cases_that_failed_come_first_and_each_policy_has_its_turn(results):
    cases = chosen_cases(results, 6)
    assert len(cases) == len(set(cases)) <= 6
    solved = np.all([result.records.success for result in results], axis=0)
    assert not solved[cases[0]]
    assert list(solved[cases]) == sorted(solved[cases])
    for result in results:
        assert set(cases) & set(failures(result))


def test_failures_of_every_kind_are_named_before_a_second_of_any(results):
    for result in results:
        found = failures(result)
        kinds = result.records.outcome[found]
        assert sorted(found) == np.flatnonzero(~result.records.success).tolist()
        assert len(set(kinds[: len(set(kinds))])) == len(set(kinds))


def test_the_closest_call_of_all_is_among_the_successes(results):
    solved = np.flatnonzero(np.all([result.records.success for result in results], axis=0))
    gaps = np.min([result.records.minimum_clearance for result in results], axis=0)
    assert solved[gaps[solved].argmin()] in solved_by_all(results)
    assert set(solved_by_all(results)) <= set(solved)
