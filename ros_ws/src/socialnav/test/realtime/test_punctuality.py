"""Laws of how punctual commands are said to be; no middleware is needed for them."""

import pytest

from socialnav.realtime.punctuality import Punctuality

PERIOD = 0.1


def facts_after(*periods, factor=1.0):
    """
    Return what is known after (moment of the tick, its lateness, moment of the command).

    The clock of the ticks runs faster by a factor.
    """
    punctuality = Punctuality(PERIOD)
    for now, lateness, moment in periods:
        punctuality.tick(now, lateness, now * factor)
        punctuality.command(moment, {'odom': 0.02, 'pedestrians': 0.03, 'goal_pose': 99.0})
    return {name: float(value) for name, value in punctuality.facts().items()}


def test_the_delay_counts_from_when_the_tick_was_due():
    assert facts_after((10.0, 0.002, 10.003))['tick to command, p50 [s]'] == 0.005


def test_the_oldest_input_counts_at_the_moment_of_the_command_and_a_goal_does_not_age():
    assert facts_after((10.0, 0.0, 10.01))['age of inputs at command, p50 [s]'] == 0.04


def test_a_period_without_a_tick_is_missed_and_a_late_tick_is_none():
    times = [0.0, 0.1, 0.4, 0.5]
    assert facts_after(*((now, 0.0, now) for now in times))['missed periods'] == 2
    late = [(0.0, 0.0), (0.19, 0.09), (0.2, 0.0)]
    assert facts_after(*((now, lateness, now) for now, lateness in late))['missed periods'] == 0


def test_a_period_of_simulated_time_may_take_longer():
    times = [0.0, 0.2, 0.4]
    assert facts_after(*((now, 0.0, now) for now in times), factor=0.5)['missed periods'] == 0


def test_a_period_without_a_command_is_not_measured():
    assert facts_after((10.0, 0.0, 9.9)).keys() == {'missed periods'}


def test_the_largest_delays_show_in_the_last_percentile():
    delays = [0.001] * 90 + [0.05] * 10
    facts = facts_after(*((n * PERIOD, 0.0, n * PERIOD + one) for n, one in enumerate(delays)))
    assert facts['tick to command, p50 [s]'] == pytest.approx(0.001)
    assert facts['tick to command, p99 [s]'] == pytest.approx(0.05)
