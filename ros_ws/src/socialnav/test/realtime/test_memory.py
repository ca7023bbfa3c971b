"""Laws of what the garbage collector passes over."""

import gc
import time
import weakref

import pytest

from socialnav.realtime import memory
from socialnav.realtime.memory import FEW, set_aside


class Cycle:
    """Something that only the collector can free."""

    def __init__(self):
        self.itself = self


@pytest.fixture(autouse=True)
def collector_as_it_was():
    """Give back to the collector what a test has set aside."""
    set_aside()
    yield
    gc.unfreeze()


def much():
    """Return as many objects as a model has."""
    return [[] for _ in range(2 * FEW)]


def test_a_collection_passes_over_what_was_set_aside_and_sees_what_came_later():
    before, _objects = Cycle(), much()
    set_aside()
    after = Cycle()
    old, new = weakref.ref(before), weakref.ref(after)
    del before, after
    gc.collect()
    assert old() is not None and new() is None


def test_garbage_that_was_set_aside_is_collected_by_the_next_call_that_finds_much():
    cycle, _objects = Cycle(), much()
    set_aside()
    kept = weakref.ref(cycle)
    del cycle
    set_aside()
    assert kept() is not None
    _more = much()
    set_aside()
    assert kept() is None


def test_what_is_little_is_collected_and_not_set_aside():
    cycle = Cycle()
    kept, frozen = weakref.ref(cycle), gc.get_freeze_count()
    del cycle
    set_aside()
    assert kept() is None and gc.get_freeze_count() <= frozen


def test_a_call_that_finds_little_takes_less_of_a_core_than_a_decision(monkeypatch):
    began = time.thread_time()
    set_aside()
    little = time.thread_time() - began
    monkeypatch.setattr(memory, 'FEW', 0)
    began = time.thread_time()
    set_aside()
    assert little < 0.01 or little < (time.thread_time() - began) / 4
