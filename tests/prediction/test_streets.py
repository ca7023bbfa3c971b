"""Laws of people in streets, and of what a tracker sees of anybody."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.training.prediction.crowds import draw_crowd, record
from socialnav_core.training.prediction.recording import Recording
from socialnav_core.training.prediction.streets import as_tracked, between, with_company


def street(seed=0, tracked=False, duration=12.0):
    """Return a recording of twenty people in a street of two worlds."""
    draws = np.random.default_rng(seed)
    crowd = draw_crowd('street', draws)
    scenario = dataclasses.replace(crowd.scenario, pedestrians=20, obstacles=0, time_step=0.25)
    crowd = dataclasses.replace(crowd, scenario=scenario, tracked=tracked)
    return record(crowd, 2, duration, 'train', 0, 0, draws)


def walkers(velocity=(1.0, 0.5), moments=41):
    """Return a recording of two people who walk side by side, straight on."""
    time = 0.25 * np.arange(moments)[:, None, None]
    position = (time * np.array(velocity) + np.array([[0.0, 0.0], [5.0, 0.0]]))[None]
    velocities = np.broadcast_to(velocity, position.shape).astype(np.float32)
    goal = (position + 10.0 * np.array(velocity)).astype(np.float32)
    return Recording(
        0.25, position.astype(np.float32), velocities.copy(), goal, np.full((1, 2), 0.3),
        np.zeros((1, 0, 2)),
    )  # fmt: skip


def test_most_people_of_a_street_walk_on_along_it():
    recording = street()
    way = recording.position[:, -1] - recording.position[:, 0]
    far = np.linalg.norm(way, axis=-1) > 3.0
    angle = np.arctan2(way[..., 1], way[..., 0])[far]
    towards = np.linalg.norm(recording.goal[:, 0] - recording.position[:, 0], axis=-1)
    assert far.mean() > 0.4 and len(angle) > 10
    np.testing.assert_allclose(towards[0, 0], 100.0, rtol=0.02)


def test_some_people_of_a_street_stand_some_of_these_set_off_and_some_stay():
    stood, left, stayed = 0, 0, 0
    for seed in range(6):
        speed = np.linalg.norm(street(seed).velocity[:, 1:], axis=-1)
        standing = speed[:, 2] < 1e-6
        stood += standing.sum()
        left += (standing & (speed.max(axis=1) > 0.2)).sum()
        stayed += (standing & (speed.max(axis=1) < 1e-6)).sum()
    assert stood > 5 and left > 0 and stayed > 0


def test_company_keeps_its_distance():
    recording = walkers()
    for seed in range(20):
        company = with_company(walkers(), np.random.default_rng(seed))
        apart = company.position[0, :, 1] - company.position[0, :, 0]
        np.testing.assert_allclose(apart, np.broadcast_to(apart[0], apart.shape), atol=1e-5)
        if np.linalg.norm(apart[0]) < 2.0:
            assert 0.4 < np.linalg.norm(apart[0]) < 0.95
            return
        np.testing.assert_array_equal(company.position, recording.position)
    pytest.fail('nobody has company')


@pytest.mark.parametrize('seed', range(5))
def test_a_tracker_sees_where_people_are_within_a_step(seed):
    recording = walkers()
    tracked = as_tracked(recording, np.random.default_rng(seed))
    assert np.abs(tracked.position - recording.position).max() < 0.5
    assert np.abs(tracked.position - recording.position).max() > 1e-3


def test_the_velocities_of_a_tracker_are_differences_to_the_moment_before():
    tracked = as_tracked(walkers(), np.random.default_rng(1))
    steps = np.diff(tracked.position, axis=1) / 0.25
    np.testing.assert_allclose(tracked.velocity[:, 1:], steps, atol=1e-4)


def test_who_is_tracked_still_comes_as_far():
    tracked = as_tracked(walkers(), np.random.default_rng(2))
    mean = (tracked.position[0, -1] - tracked.position[0, 0]) / 10.0
    np.testing.assert_allclose(mean, [[1.0, 0.5]] * 2, atol=0.1)


def test_values_between_moments_are_on_the_line_and_those_at_moments_themselves():
    values = np.arange(5.0)[None, :, None, None] ** 2
    found = between(values, np.array([0.0, 1.5, 4.0]))
    np.testing.assert_allclose(found[0, :, 0, 0], [0.0, 2.5, 16.0])
