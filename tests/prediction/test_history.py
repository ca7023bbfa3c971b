"""Laws of the velocities that are remembered."""

import dataclasses

from crowd_states import random_state
import numpy as np
import pytest

from socialnav_core.prediction.learned.history import History


def at(time, velocity):
    """Return a world with one person, at a time."""
    state = random_state(1, obstacles=0, batch=1)
    state.agents.velocity[:] = velocity
    return dataclasses.replace(state, time=np.array([time]))


def lagged_after(times):
    """Return the lagged velocities of somebody whose velocity is the time."""
    history = History()
    for time in times:
        history.update(at(time, time))
    lagged, known = history.lagged()
    return lagged[0, :, 0, 0], known[0, :, 0]


@pytest.mark.parametrize('step', [0.02, 0.05, 0.1, 0.125, 0.2, 0.25, 0.4, 0.5])
def test_lagged_velocities_do_not_depend_on_the_time_step(step):
    times = np.arange(0.0, 4.0 + 1e-9, step)
    lagged, known = lagged_after(times)
    assert known.all()
    np.testing.assert_allclose(lagged, times[-1] - 0.25 * np.arange(6), atol=1e-9)


def test_what_is_older_than_the_first_sample_is_unknown_and_zero():
    lagged, known = lagged_after([1.0, 1.25, 1.5])
    np.testing.assert_array_equal(known, [True, True, True, False, False, False])
    np.testing.assert_array_equal(lagged, [1.5, 1.25, 1.0, 0.0, 0.0, 0.0])


def test_a_long_gap_forgets():
    _, known = lagged_after([0.0, 0.25, 2.0])
    np.testing.assert_array_equal(known, [True] + [False] * 5)


def test_a_larger_batch_or_another_number_of_slots_starts_without_past():
    history = History()
    history.update(random_state(2, batch=1))
    history.update(random_state(2, batch=3))
    assert history.lagged()[1][:, 0].all() and not history.lagged()[1][:, 1:].any()
    history.update(random_state(4, batch=3))
    assert history.lagged()[1].shape == (3, 6, 6)


def test_identities_that_nobody_had_are_new():
    history = History()
    for time in (0.0, 0.25):
        history.update(at(time, 1.0), np.array([[5]]))
    history.update(at(0.5, 1.0), np.array([[6]]))
    np.testing.assert_array_equal(history.lagged()[1][0, :, 0], [True] + [False] * 5)
