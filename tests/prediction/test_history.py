"""Laws of the velocities that are remembered."""

import dataclasses

from crowd_states import random_state
import numpy as np
import pytest

from socialnav_core.prediction.learned.history import History


def at(time, velocity):
    """Return a world with one person who speeds up steadily, at a time."""
    state = random_state(1, obstacles=0, batch=1)
    state.agents.velocity[:] = velocity
    state.agents.position[:] = 0.5 * velocity**2
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
    history.update(random_state(2, obstacles=0, batch=1))
    history.update(random_state(2, obstacles=0, batch=3))
    assert history.lagged()[1][:, 0].all() and not history.lagged()[1][:, 1:].any()
    history.update(random_state(4, obstacles=0, batch=3))
    assert history.lagged()[1].shape == (3, 6, 4)


def people_at(time, places, velocity=(1.0, 0.0), static=()):
    """Return a world with people at some places, m, at a time."""
    state = random_state(len(places), obstacles=0, batch=1)
    state.agents.position[0], state.agents.velocity[:] = np.reshape(places, (-1, 2)), velocity
    state.agents.static[0, list(static)] = True
    return dataclasses.replace(state, time=np.array([time]))


def pasts_after(*states):
    """Return how many lags are known of each agent, and the motions at the lags."""
    history = History()
    for state in states:
        history.update(state)
    lagged, known = history.lagged()
    return known[0].sum(axis=0).tolist(), lagged[0]


WALK = [(0.0, 0.0), (3.0, 1.0), (0.0, 5.0)]


def walked(time, order=(0, 1, 2)):
    """Return those of WALK after a time, in an order of slots."""
    return people_at(time, [(WALK[person][0] + time, WALK[person][1]) for person in order])


def test_people_who_change_slots_keep_their_past():
    known, lagged = pasts_after(walked(0.0), walked(0.25), walked(0.5, (2, 0, 1)))
    assert known == [3, 3, 3]
    np.testing.assert_allclose(lagged[2, :, 2:], [WALK[2], WALK[0], WALK[1]])


def test_the_past_of_who_leaves_goes_to_nobody_else():
    known, lagged = pasts_after(walked(0.0), walked(0.25), walked(0.5, (1, 2)))
    assert known == [3, 3]
    np.testing.assert_allclose(lagged[2, :, 2:], [WALK[1], WALK[2]])


def test_who_comes_is_new_and_the_others_are_not():
    known, _ = pasts_after(walked(0.0, (0, 2)), walked(0.25, (0, 2)), walked(0.5))
    assert known == [3, 1, 3]


def test_who_is_where_nobody_could_have_walked_to_is_new():
    known, _ = pasts_after(walked(0.0), walked(0.25), people_at(0.5, [(0.5, 0), (9, 9), (0.5, 5)]))
    assert known == [3, 1, 3]


@pytest.mark.parametrize('step', [0.1, 0.25, 0.4])
def test_who_turns_back_at_once_is_no_other(step):
    there = [people_at(count * step, [(count * step, 0.0)]) for count in range(4)]
    back = people_at(4 * step, [(2 * step, 0.0)], (-1.0, 0.0))
    known, lagged = pasts_after(*there, back)
    assert known[0] > 1 and lagged[0, 0, 0] == -1.0


def test_who_is_missed_once_keeps_the_past():
    missed = walked(0.25)
    missed.agents.valid[0, 1] = False
    known, _ = pasts_after(walked(0.0), missed, walked(0.5))
    assert known[0] == known[2] == 3
    history = History()
    for state in (walked(-0.25), walked(0.0), missed, walked(0.5)):
        history.update(state)
    _, seen = history.lagged()
    np.testing.assert_array_equal(seen[0, :4, 1], [True, False, True, True])


def test_a_person_in_the_slot_of_a_former_obstacle_is_new():
    before, after = people_at(0.0, WALK, static=[1]), walked(0.25)
    assert pasts_after(before, after)[0] == [2, 1, 2]


def test_worlds_are_followed_each_on_its_own():
    history, both = History(), random_state(3, obstacles=0, batch=2)
    for step in range(3):
        agents = both.agents
        order = np.array([[0, 1, 2], [2, 0, 1] if step == 2 else [0, 1, 2]])
        moved = agents.position + 0.25 * step * agents.velocity
        turned = both.with_agents(
            position=np.take_along_axis(moved, order[..., None], axis=1),
            velocity=np.take_along_axis(agents.velocity, order[..., None], axis=1),
        )
        history.update(dataclasses.replace(turned, time=0.25 * step * np.ones(2)))
    lagged, known = history.lagged()
    assert known[:, :3].all()
    expected = np.take_along_axis(agents.position, order[..., None], axis=1)
    np.testing.assert_allclose(lagged[:, 2, :, 2:], expected, atol=1e-12)
