"""Laws of the examples that the network learns from."""

import numpy as np
import pytest

from socialnav_core.config.prediction import NoiseConfig
from socialnav_core.prediction.learned.features import person_features
from socialnav_core.prediction.learned.history import History, lagged_motions
from socialnav_core.prediction.learned.layout import LAG, LAGS, OWN
from socialnav_core.training.prediction.crowds import draw_crowd, record
from socialnav_core.training.prediction.examples import (
    draw_examples,
    everybody,
    seen_samples,
)
from socialnav_core.training.prediction.recording import Recording

QUIET = NoiseConfig(share=0.0, forgetting=0.0)


def recorded(time_step=0.25, kind='social_force'):
    """Return a recording with another time step."""
    draws = np.random.default_rng(3)
    crowd = draw_crowd(kind, draws)
    recording = record(crowd, 2, 8.0, 'train', 0, 0, draws)
    recording.time_step = time_step
    return recording


def straight_on():
    """Return a recording of people who keep their velocities, for 10 s."""
    draws = np.random.default_rng(0)
    velocity = np.repeat(draws.uniform(-1, 1, (1, 1, 4, 2)), 41, axis=1).astype(np.float32)
    time = 0.25 * np.arange(41)[None, :, None, None]
    position = (draws.uniform(-3, 3, (1, 1, 4, 2)) + velocity * time).astype(np.float32)
    return Recording(0.25, position, velocity, position + 2 * velocity, np.full((1, 4), 0.3),
                     np.zeros((1, 0, 2)))  # fmt: skip


@pytest.mark.parametrize('time_step', [0.1, 0.125, 0.2, 0.25])
def test_training_sees_what_a_robot_sees(time_step):
    recording, moment = recorded(time_step), 18
    history = History()
    for step in range(moment + 1):
        state = recording.state(step)
        history.update(state)
    lagged, known = history.lagged()
    agents = state.agents
    _, features, frames = person_features(
        agents.position, lagged, known, agents.radius, agents.static, agents.valid
    )
    world, moments = np.arange(2), np.full(2, moment)
    samples = seen_samples(recording, world, moments, 0.0, np.random.default_rng(0))
    learned, turned = everybody(
        recording, world, agents.position[:, : recording.people], *lagged_motions(*samples)
    )
    np.testing.assert_array_equal(learned, features)
    np.testing.assert_array_equal(turned, frames)


def test_who_keeps_their_velocity_has_no_residual_and_the_goal_ahead():
    examples = draw_examples([straight_on()], 20, QUIET, np.random.default_rng(0))
    np.testing.assert_allclose(examples.residual, 0.0, atol=1e-4)
    np.testing.assert_allclose(examples.goal, np.tile([1.0, 0.0], (80, 1)), atol=1e-4)


def test_noise_moves_the_residual_by_what_was_seen_wrongly():
    noise = NoiseConfig(share=1.0, forgetting=0.0)
    examples = draw_examples([straight_on()], 200, noise, np.random.default_rng(0))
    assert 0.01 < np.abs(examples.residual[:, 0]).mean() < 0.2


def test_the_future_lies_between_the_moments_that_were_recorded():
    recording = recorded()
    found = recording.future(np.array([1]), np.array([4]), np.array([0.0, 0.1, 0.25]))[0]
    before, after = recording.position[1, 4], recording.position[1, 5]
    np.testing.assert_array_equal(found[[0, 2]], [before, after])
    np.testing.assert_allclose(found[1], 0.6 * before + 0.4 * after, atol=1e-6)


PAST, JITTER, CROWD = 3 + 2 * LAGS, 1 + 4 * LAGS, OWN - 4
"""Where features of the person begin: mean velocities since the lags, jitter, the crowd."""


def own_features(lagged, known=None, position=None):
    """Return the features of the first of some people, who has a past, (1, LAGS, people, 4)."""
    shape = lagged.shape[:3]
    known = np.ones(shape, bool) if known is None else known
    position = lagged[:, 0, :, 2:] if position is None else position
    one = np.ones((1, shape[2]), bool)
    _, features, _ = person_features(position, lagged, known, 0.3 * one, ~one, one)
    return features[0]


def walk(velocity=(1.0, 0.0)):
    """Return the motions of somebody who walks straight on, (1, LAGS, 1, 4)."""
    past = -LAG * np.arange(LAGS)[:, None] * np.array(velocity)
    motions = np.concatenate([np.tile(velocity, (LAGS, 1)), past], axis=1)
    return motions[None, :, None]


def test_positions_and_velocities_that_agree_leave_no_difference():
    features = own_features(walk((0.6, 0.8)))
    np.testing.assert_allclose(features[PAST : JITTER + 1], 0.0, atol=1e-6)


def test_positions_tell_a_wrong_velocity():
    motions = walk()
    motions[0, 0, 0, 0] = 1.5
    features = own_features(motions)
    np.testing.assert_allclose(features[PAST:JITTER:2], -0.5, atol=1e-6)
    assert features[JITTER] > 0.2


def test_what_is_not_known_of_the_past_says_nothing():
    motions, known = walk(), np.ones((1, LAGS, 1), bool)
    motions[0, 3:], known[0, 3:] = 77.0, False
    features = own_features(motions, known)
    np.testing.assert_allclose(features[PAST : JITTER + 1], 0.0, atol=1e-6)


def test_the_crowd_is_seen_from_where_the_person_is():
    motions = np.repeat(walk(), 3, axis=2)
    position = np.array([[[0.0, 0.0], [3.0, 3.0], [3.0, -3.0]]])
    features = own_features(motions, position=position)
    spread = np.sqrt((4.0 + 2 * 10.0) / 3)
    np.testing.assert_allclose(features[CROWD:OWN], [0.4, 0.0, 0.2 * spread, 0.15], atol=1e-5)
    far = own_features(motions, position=100.0 * position)
    assert np.abs(far[CROWD:OWN]).max() < 2.0
