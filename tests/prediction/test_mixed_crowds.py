"""Laws of the crowds that predictions are learned from."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.prediction import CrowdMixture, CrowdsConfig, SHARES
from socialnav_core.simulation.crowds.social_force_kernel import social_force_step
from socialnav_core.training.prediction.crowds import draw_crowd, draw_kind, record
from socialnav_core.training.prediction.dataset import record_crowds

SMALL = CrowdsConfig(groups=3, validation_groups=2, worlds=2, duration=5.0)


def recording_of(kind, seed=0, **scenario):
    """Return a short recording of a kind of crowd."""
    draws = np.random.default_rng(seed)
    crowd = draw_crowd(kind, draws)
    crowd = dataclasses.replace(
        crowd, scenario=dataclasses.replace(crowd.scenario, **scenario), unaware_share=1.0
    )
    return record(crowd, 2, 6.0, 'train', 0, 0, draws)


@pytest.mark.parametrize('kind', SHARES)
def test_people_move_as_their_velocities_say(kind):
    recording = recording_of(kind, pedestrians=6, obstacles=2)
    steps = np.diff(recording.position, axis=1)
    assert np.abs(steps).max() > 0.01
    np.testing.assert_allclose(steps, recording.velocity[:, 1:] * recording.time_step, atol=1e-4)


def test_people_of_social_forces_stay_nearly_clear_of_each_other():
    recording = recording_of('social_force', pedestrians=8, obstacles=0)
    offset = recording.position[:, :, :, None] - recording.position[:, :, None]
    gap = np.linalg.norm(offset, axis=-1) - (
        recording.radius[:, None, :, None] + recording.radius[:, None, None]
    )
    gap[:, :, np.arange(8), np.arange(8)] = np.inf
    assert gap.min() > -0.2


def test_who_pauses_stands_and_goes_on():
    recording = recording_of('stop_and_go', pedestrians=20, obstacles=0)
    standing = (recording.velocity == 0.0).all(axis=-1)
    walked = ~standing
    stops = walked[:, :-1] & standing[:, 1:]
    starts = standing[:, 1:-1] & walked[:, 2:]
    assert stops.any() and starts.any()


def test_who_avoids_nobody_walks_straight_to_the_goal():
    recording = recording_of('unaware', pedestrians=10, obstacles=0)
    before, after = recording.velocity[:, 2:-1], recording.velocity[:, 3:]
    same_goal = (recording.goal[:, 1:-2] == recording.goal[:, 2:-1]).all(axis=-1)
    cross = before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0]
    assert np.abs(cross[same_goal]).max() < 1e-3


def test_who_passes_never_turns_back():
    draws = np.random.default_rng(0)
    crowd = dataclasses.replace(draw_crowd('varied', draws), passing=True)
    recording = record(crowd, 2, 6.0, 'train', 0, 0, draws)
    way = recording.goal[:, 0] - recording.position[:, 0]
    assert (np.linalg.norm(way, axis=-1) > 90.0).all()
    assert (recording.goal == recording.goal[:, :1]).all()


def test_the_same_seed_records_the_same_and_the_splits_differ():
    first, again = record_crowds(SMALL, 0, 'train'), record_crowds(SMALL, 0, 'train')
    for one, other in zip(first, again, strict=True):
        np.testing.assert_array_equal(one.position, other.position)
    validation = record_crowds(SMALL, 0, 'validation')
    assert len(validation) == 2
    assert (
        first[0].position.shape != validation[0].position.shape
        or (first[0].position != validation[0].position).any()
    )


def test_a_share_of_zero_is_never_drawn():
    mixture = CrowdMixture(0.0, 0.0, 1.0, 0.0, 1.0, 0.0)
    draws = np.random.default_rng(0)
    assert {draw_kind(mixture, draws) for _ in range(50)} == {'stop_and_go', 'social_force'}


def test_shares_that_are_none_are_refused():
    with pytest.raises(ConfigError, match='shares'):
        CrowdMixture(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def pushed(position, preferred, speed=1.0):
    """Return the velocities of two people after a step of .25 s from rest."""
    position, out = np.array([position], float), np.zeros((1, 2, 2))
    arrays = (np.zeros((1, 2, 2)), np.array([preferred], float))
    same = np.full((1, 2), 0.3)
    social_force_step(
        position, *arrays, same, np.full((1, 2), speed), 2, 2.0, 0.3, 0.5, 0.3, 0.25, out
    )
    return out[0]


def test_people_who_meet_push_each_other_away_alike():
    velocity = pushed([[0, 0], [0.7, 0]], [[0, 0], [0, 0]])
    assert velocity[0, 0] < -0.05
    np.testing.assert_allclose(velocity[0], -velocity[1], atol=1e-12)


def test_people_far_from_each_other_take_up_their_preferred_velocities():
    velocity = pushed([[0, 0], [50, 0]], [[0, 1], [0, -1]])
    assert 0.1 < velocity[0, 1] < 1.0
    np.testing.assert_allclose(velocity[0, 0], 0.0, atol=1e-12)
