"""Laws of the window of episodes."""

import numpy as np
import pytest

from socialnav_core.simulation import Outcome
from socialnav_core.training.episodes import EpisodeWindow


def record(window, cases, outcomes, time=10.0):
    """Add episodes that ended."""
    window.record(np.array(cases), np.array(outcomes), np.full(len(cases), time))


def test_episode_waits_for_all_that_started_before_it():
    window = EpisodeWindow(10, next_case=0)
    record(window, [1, 2], [Outcome.GOAL, Outcome.GOAL])
    assert np.isnan(window.success_rate)
    record(window, [0], [Outcome.TIMEOUT])
    assert window.success_rate == pytest.approx(2 / 3)


def test_window_holds_the_episodes_that_started_last():
    window = EpisodeWindow(2, next_case=0)
    record(window, [2, 1, 0], [Outcome.GOAL, Outcome.GOAL, Outcome.COLLISION_OBSTACLE])
    assert window.full and window.success_rate == 1.0


def test_episodes_begun_before_a_restart_are_not_counted():
    window = EpisodeWindow(2, next_case=0)
    record(window, [0, 3], [Outcome.GOAL, Outcome.GOAL])
    window.restart(next_case=5)
    record(window, [1, 2, 4], [Outcome.GOAL] * 3)
    record(window, [6, 5], [Outcome.GOAL, Outcome.COLLISION_PEDESTRIAN])
    assert window.full and window.success_rate == 0.5


def test_leaving_the_bounds_counts_as_a_collision_and_a_timeout_as_neither():
    window = EpisodeWindow(4, next_case=0)
    outcomes = [Outcome.OUT_OF_BOUNDS, Outcome.TIMEOUT, Outcome.GOAL, Outcome.COLLISION_OBSTACLE]
    record(window, range(4), outcomes)
    assert (window.success_rate, window.collision_rate) == (0.25, 0.5)


def test_mean_time_is_over_successes():
    window = EpisodeWindow(4, next_case=0)
    record(window, [0], [Outcome.GOAL], time=8.0)
    record(window, [1], [Outcome.TIMEOUT], time=25.0)
    assert window.mean_time == 8.0


def test_stored_window_goes_on_like_the_original():
    original, copy = EpisodeWindow(3, next_case=0), EpisodeWindow(3, next_case=0)
    record(original, [0, 2, 4], [Outcome.GOAL, Outcome.TIMEOUT, Outcome.GOAL])
    copy.set_state(original.get_state())
    for window in (original, copy):
        record(window, [1, 3], [Outcome.COLLISION_OBSTACLE, Outcome.GOAL])
    assert copy.full and copy.success_rate == original.success_rate == pytest.approx(2 / 3)
    assert copy.next_case == original.next_case == 5
