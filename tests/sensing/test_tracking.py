"""Laws of tracks."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.sensing import Tracker, TrackerSettings
from socialnav_core.sensing.tracking import inverse, MOST_TRACKS

STEP = 0.05
SETTINGS = TrackerSettings(confirmation_time=0.0)


def tracker(**changes):
    return Tracker(dataclasses.replace(SETTINGS, **changes))


def walk(filters, start, velocity, steps, noise=0.0, seed=0, first=0):
    """Let people walk straight; return the last tracks."""
    generator = np.random.default_rng(seed)
    start, velocity = np.array(start, float), np.array(velocity, float)
    for step in range(first, first + steps):
        true = start + velocity * STEP * step
        found = true + noise * generator.standard_normal(true.shape)
        tracks = filters.update(step * STEP, found[generator.permutation(len(found))])
    return tracks


def test_velocities_converge_to_the_true_ones():
    velocity = np.array([[1.0, -0.5]])
    tracks = walk(tracker(), [[0.0, 0.0]], velocity, 40)
    np.testing.assert_allclose(tracks.velocity, velocity, atol=0.02)


def test_noisy_velocities_are_better_than_differences_of_detections():
    errors = [
        walk(tracker(), [[0.0, 0.0]], [[1.0, 0.0]], 40, noise=0.05, seed=seed).velocity[0]
        - [1.0, 0.0]
        for seed in range(30)
    ]
    assert np.sqrt(np.mean(np.square(errors))) < 0.3 < 0.05 * np.sqrt(2) / STEP


def test_an_id_stays_with_its_person_in_a_shuffled_crowd():
    start = [[0.0, float(row)] for row in range(6)]
    filters, velocity = tracker(), [[1.0 - 0.3 * row, 0.0] for row in range(6)]
    before = walk(filters, start, velocity, 10)
    after = walk(filters, start, velocity, 30, first=10)
    owners = [
        dict(zip(np.round(tracks.position[:, 1]).tolist(), tracks.id.tolist(), strict=True))
        for tracks in (before, after)
    ]
    assert owners[0] == owners[1] and len(owners[0]) == 6


def test_people_who_cross_keep_their_velocities():
    filters, start, velocity = tracker(), [[-1.0, 0.0], [1.0, 0.2]], [[1.0, 0.0], [-1.0, 0.0]]
    before = walk(filters, start, velocity, 10)
    after = walk(filters, start, velocity, 30, first=10)
    assert after.id.tolist() == before.id.tolist()
    np.testing.assert_array_equal(np.sign(after.velocity[:, 0]), np.sign(before.velocity[:, 0]))
    np.testing.assert_allclose(np.abs(after.velocity[:, 0]), 1.0, atol=0.05)


def test_a_track_without_detections_goes_on_and_dies_after_the_coast_time():
    filters = tracker(coast_time=0.5)
    last = walk(filters, [[0.0, 0.0]], [[1.0, 0.0]], 40)
    coasting = filters.update(39 * STEP + 0.4, np.zeros((0, 2)))
    assert coasting.id.tolist() == last.id.tolist()
    np.testing.assert_allclose(coasting.position, last.position + [[0.4, 0.0]], atol=0.02)
    assert len(filters.update(39 * STEP + 0.6, np.zeros((0, 2))).id) == 0


def test_a_person_who_comes_back_after_the_coast_time_is_another_one():
    filters = tracker()
    first = walk(filters, [[0.0, 0.0]], [[0.0, 0.0]], 3)
    later = filters.update(5.0, np.array([[0.0, 0.0]]))
    assert len(later.id) == 1 and later.id[0] != first.id[0]


def test_a_track_stands_until_it_has_been_seen_for_long_enough():
    filters = tracker(confirmation_time=2 * STEP)
    told = [filters.update(step * STEP, np.array([[1.0 + step * STEP, 1.0]])) for step in range(4)]
    assert [len(one.id) for one in told] == [1, 1, 1, 1]
    assert [one.confirmed.item() for one in told] == [False, False, True, True]
    assert [bool(one.velocity.any()) for one in told] == [False, False, True, True]


@pytest.mark.parametrize('interval', [0.05, 0.4])
def test_how_often_a_person_must_be_seen_does_not_depend_on_the_detector(interval):
    filters = tracker(confirmation_time=0.4)
    times = np.arange(0.0, 0.81, interval)
    told = [filters.update(time, np.array([[1.0, 1.0]])).confirmed.item() for time in times]
    assert told == [time >= 0.4 - 1e-9 for time in times]


def test_the_number_of_tracks_has_an_end_and_the_newest_stay():
    filters = tracker(gate=0.1, coast_time=100.0)
    crowd = np.random.default_rng(0).uniform(-1000.0, 1000.0, (6, 300, 2))
    for step, positions in enumerate(crowd):
        tracks = filters.update(step * STEP, positions)
    assert len(tracks.id) == MOST_TRACKS
    np.testing.assert_array_equal(tracks.position[-300:], crowd[-1])


def test_a_detection_beyond_the_gate_begins_a_track_of_its_own():
    filters = tracker()
    walk(filters, [[0.0, 0.0]], [[0.0, 0.0]], 20)
    tracks = filters.update(20 * STEP, np.array([[3.0, 0.0]]))
    assert len(tracks.id) == 2


def test_nobody_detected_from_the_beginning_is_nobody_there():
    tracks = tracker().update(0.0, np.zeros((0, 2)))
    assert (tracks.id.shape, tracks.position.shape) == ((0,), (0, 2))


def test_a_clock_that_runs_backwards_makes_everybody_new():
    filters = tracker()
    before = walk(filters, [[0.0, 0.0]], [[1.0, 0.0]], 10)
    after = filters.update(0.0, np.array([[0.45, 0.0]]))
    assert set(after.id).isdisjoint(before.id) and len(after.id) == 1


@pytest.mark.parametrize('rate', [1.0, 2.0])
def test_the_filter_does_not_depend_on_how_time_is_cut(rate):
    once, cut = tracker(), tracker()
    for filters in (once, cut):
        walk(filters, [[0.0, 0.0]], [[1.0, 0.0]], 20)
    for part in (0.1, 0.2):
        cut.update(19 * STEP + part * rate / 2, np.zeros((0, 2)))
    nobody = np.zeros((0, 2))
    single = once.update(19 * STEP + 0.2 * rate, nobody)
    double = cut.update(19 * STEP + 0.2 * rate, nobody)
    np.testing.assert_allclose(single.position, double.position)


def test_a_matrix_times_its_inverse_is_one():
    root = np.random.default_rng(0).normal(size=(5, 2, 2))
    matrices = root @ root.transpose(0, 2, 1) + 0.1 * np.eye(2)
    np.testing.assert_allclose(
        matrices @ inverse(matrices), np.tile(np.eye(2), (5, 1, 1)), atol=1e-9
    )
