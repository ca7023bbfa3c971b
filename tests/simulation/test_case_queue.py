"""Laws of the cases that are still to be run."""

import numpy as np
import pytest

from socialnav_core.simulation.case_queue import CaseQueue, queue_of


def test_cases_are_handed_out_once_each_in_order_until_none_is_left():
    queue = queue_of(0, 'test', [7, 3, 5])
    assert [queue.take(2).tolist() for _ in range(3)] == [[7, 3], [5], []]


def test_without_a_list_cases_never_end():
    queue = queue_of(0, 'test')
    assert queue.take(3).tolist() == [0, 1, 2] and queue.take(2).tolist() == [3, 4]


@pytest.mark.parametrize('cases', [None, [], [4, 2**32 - 1]])
def test_arrays_hold_everything(cases):
    queue = queue_of(2**64 - 2, 'validation', cases)
    queue.take(1)
    copy = CaseQueue.from_arrays(queue.arrays())
    assert (copy.seed, copy.split, copy.taken) == (2**64 - 2, 'validation', queue.taken)
    assert np.array_equal(copy.take(5), queue.take(5))


@pytest.mark.parametrize(
    ('seed', 'split', 'cases'), [(-1, 'test', None), (0, 'exam', None), (0, 'test', [2**32])]
)
def test_what_does_not_exist_is_refused(seed, split, cases):
    with pytest.raises(ValueError, match='must'):
        queue_of(seed, split, cases)


@pytest.mark.parametrize(
    ('seed', 'cases'),
    [
        (None, None),
        (1.5, None),
        (True, None),
        ('1', None),
        (0, [1.5]),
        (0, ['a']),
        (0, 3),
        (0, 'ab'),
    ],
)
def test_seeds_and_cases_are_whole_numbers(seed, cases):
    with pytest.raises(ValueError, match='whole number'):
        queue_of(seed, 'test', cases)
