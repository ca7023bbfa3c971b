"""Laws of what the garbage collector passes over."""

import gc
import weakref

import pytest

from socialnav.realtime.memory import set_aside


class Cycle:
    """Something that only the collector can free."""

    def __init__(self):
        self.itself = self


@pytest.fixture(autouse=True)
def collector_as_it_was():
    """Give back to the collector what a test has set aside."""
    yield
    gc.unfreeze()


def test_a_collection_passes_over_what_was_set_aside_and_sees_what_came_later():
    before = Cycle()
    set_aside()
    after = Cycle()
    old, new = weakref.ref(before), weakref.ref(after)
    del before, after
    gc.collect()
    assert old() is not None and new() is None


def test_garbage_that_was_set_aside_is_collected_by_the_next_call():
    cycle = Cycle()
    set_aside()
    kept = weakref.ref(cycle)
    del cycle
    set_aside()
    assert kept() is None
