"""Laws of the watchdog; no middleware is needed for them."""

from contextlib import contextmanager
from queue import Queue
import time

from socialnav.realtime.watchdog import Watchdog

DEADLINE = 60.0
"""Time that anything may take before a test fails, s."""


@contextmanager
def watching(timeout):
    """Yield a watchdog and the moments of its calls."""
    calls = Queue()
    watchdog = Watchdog(timeout, lambda: calls.put(time.monotonic()))
    try:
        yield watchdog, calls
    finally:
        watchdog.stop()


def test_without_food_it_calls_again_and_again_but_never_before_the_time_is_over():
    began = time.monotonic()
    with watching(0.05) as (_, calls):
        moments = [calls.get(timeout=DEADLINE) for _ in range(3)]
    assert moments[0] - began >= 0.05 and moments[2] - began >= 0.15


def test_food_puts_the_call_off_though_it_wakes_nobody():
    with watching(1.0) as (watchdog, calls):
        end = time.monotonic() + 0.5
        while time.monotonic() < end:
            watchdog.feed()
        assert calls.get(timeout=DEADLINE) - end >= 0.9


def test_its_end_wakes_it():
    with watching(60.0) as (watchdog, _):
        began = time.monotonic()
        watchdog.stop()
        assert time.monotonic() - began < 30.0


def test_after_its_end_it_calls_no_more():
    with watching(0.02) as (watchdog, calls):
        calls.get(timeout=DEADLINE)
        watchdog.stop()
        count = calls.qsize()
        time.sleep(0.2)
        assert calls.qsize() == count


def test_another_watchdog_may_know_when_there_was_food_last():
    calls = Queue()
    watchdog = Watchdog(60.0, lambda: calls.put(1), fed=time.monotonic() - 61.0)
    calls.get(timeout=DEADLINE / 2)
    watchdog.stop()
