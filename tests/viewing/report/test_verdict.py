"""Laws of the words at the top of the page: they say what the figures say, and no more."""

import dataclasses

from made_report import made_results
import numpy as np
import pytest

from socialnav_core.evaluation import compare
from socialnav_core.simulation import make_scenario, Outcome
from socialnav_core.viewing.report.verdict import cautions, listed, reason, Standing, verdict


@pytest.fixture(scope='module')
def result():
    [alone] = made_results(make_scenario('circle'), 200, ['straight_line'])
    return alone


def like(result, name, failed, slower=0.0, **policy):
    """Return the result of a policy that fails in some cases and else arrives at another time."""
    outcome = np.full(result.episodes, Outcome.GOAL, np.int8)
    outcome[failed] = Outcome.COLLISION_PEDESTRIAN
    # times must differ from case to case for an interval of their difference
    times = 10.0 + slower * np.linspace(0.5, 1.5, result.episodes)
    records = dataclasses.replace(result.records, outcome=outcome, time=times)
    described = dataclasses.replace(result.policy, **policy)
    return dataclasses.replace(result, model=name, records=records, policy=described)


def standing(*results, title='circle'):
    return Standing(title, results, compare(results) if len(results) > 1 else [])


def test_the_one_that_succeeds_more_often_beyond_chance_is_to_be_used(result):
    good, bad = like(result, 'good', []), like(result, 'bad', range(40))
    for results in ((good, bad), (bad, good)):
        text = verdict([standing(*results)])
        assert text.headline.startswith('Use good: it reaches its goal most often in circle')
        assert 'do not overlap, and the difference is beyond chance (p < 0.001)' in text.reasons[0]


def test_overlapping_intervals_are_said(result):
    first, second = like(result, 'first', [1]), like(result, 'second', [2, 3])
    text = verdict([standing(first, second)])
    assert text.headline.startswith('No clear choice between first and second')
    assert 'first and second overlap, and the difference may be chance (p = 1)' in text.reasons[0]
    assert 'Neither arrives clearly sooner.' in text.reasons[0]


def test_intervals_that_overlap_do_not_hide_a_paired_difference(result):
    text = reason(standing(like(result, 'a', []), like(result, 'b', range(6))))
    assert 'overlap, yet case by case the difference is beyond chance' in text


def test_among_equals_the_faster_one_is_to_be_used(result):
    slow, quick = like(result, 'slow', [], slower=2.0), like(result, 'quick', [])
    text = verdict([standing(slow, quick)])
    assert text.headline.startswith('Use quick: success alone does not tell it from slow')
    assert 'Where both arrive, quick is 2.00 s sooner [' in text.reasons[0]


def test_equal_rates_are_called_equal(result):
    text = reason(standing(like(result, 'a', [1, 2]), like(result, 'b', [2, 3])))
    assert 'a and b succeed equally often. Neither arrives clearly sooner.' in text


def test_it_can_depend_on_the_world(result):
    here = standing(like(result, 'a', []), like(result, 'b', range(40)), title='here')
    there = standing(like(result, 'a', range(40)), like(result, 'b', []), title='there')
    assert verdict([here, there]).headline == 'It depends on the world: a in here; b in there.'


def test_the_worlds_in_which_the_choice_is_clear_are_named(result):
    here = standing(like(result, 'a', []), like(result, 'b', range(40)), title='here')
    there = standing(like(result, 'a', [0]), like(result, 'b', [1]), title='there')
    assert 'Use a: it reaches its goal most often in here, and' in verdict([here, there]).headline


def test_who_knows_the_future_is_never_recommended(result):
    oracle = like(result, 'oracle', [], knowledge='oracle')
    text = verdict([standing(oracle, like(result, 'a', range(40)), like(result, 'b', [0]))])
    assert text.headline.startswith('Use b:')
    assert any('what people will do: oracle.' in caution for caution in text.cautions)
    assert verdict([standing(oracle, like(result, 'a', [0]))]).headline.startswith('Use a: what')


def test_one_policy_alone_is_told_with_its_interval_and_its_failures(result):
    text = verdict([standing(like(result, 'alone', [5]))])
    assert text.headline == 'alone reached its goal in 99.5 % [97.2, 99.9] in circle.'
    assert 'The others: 1 collisions with people.' in text.reasons[0]


def test_few_cases_and_other_splits_are_warned_of(result):
    assert len(cautions([standing(like(result, 'a', []))])) == 1  # made of validation cases
    [few] = made_results(make_scenario('circle'), 5, ['straight_line'])
    assert any('are few' in caution for caution in cautions([standing(few)]))


def test_words_are_listed_as_in_a_sentence():
    assert [listed(list(words)) for words in ('a', 'ab', 'abc')] == ['a', 'a and b', 'a, b and c']
