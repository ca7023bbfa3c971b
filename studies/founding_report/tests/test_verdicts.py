"""A verdict says what a figure is to the report's."""

import pytest

from founding_report.report_figures import reported
from founding_report.verdicts import rate_verdict, reported_interval, time_verdict


@pytest.mark.parametrize('ours', [0.958, 0.958 - 1e-12, 1.0])
def test_as_many_successes_are_enough(ours):
    assert rate_verdict(0.958, ours, more_is_better=True) == 'at or above the report'


def test_a_little_less_lies_inside_the_interval_and_less_is_missed():
    low, _ = reported_interval(0.958)
    assert rate_verdict(0.958, low + 1e-6, True).startswith('inside its interval [0.937')
    assert rate_verdict(0.958, low - 1e-3, True) == f'missed by {0.958 - low + 1e-3:.3f}'


def test_more_collisions_are_worse():
    assert rate_verdict(0.014, 0.014, more_is_better=False) == 'at or below the report'
    assert rate_verdict(0.014, 0.2, more_is_better=False) == 'missed by 0.186'


def test_times_are_compared_without_interval():
    assert time_verdict(11.46, 10.46) == '1.00 s faster'
    assert time_verdict(11.46, 12.46) == '1.00 s slower'
    assert time_verdict(11.46, None) == 'no success'


def test_other_forms_of_a_system_have_its_figures():
    assert reported('gat4sn_linear', 'hard') == reported('gat4sn', 'hard')
    assert reported('gat4sn_v2', 'hard') is None
