"""Laws of the means and deviations that a trained network gives."""

from crowd_states import last_prediction, random_state, sequence, TIMES
import numpy as np
import torch

from socialnav_core.prediction.learned import LearnedPredictor
from socialnav_core.prediction.learned.layout import INPUTS, OUTPUTS, SCALE, STEPS
from socialnav_core.prediction.learned.outputs import place
from socialnav_core.training.prediction.network import (
    believed,
    build_network,
    calibrated,
    inference_weights,
)
from socialnav_core.training.prediction.validation import calibration


def test_a_factor_of_deviations_changes_these_alone():
    weights = inference_weights(build_network(32, 0))
    states, factors = sequence(random_state(4, obstacles=0)), np.linspace(0.5, 2.0, STEPS)
    plain = last_prediction(LearnedPredictor(weights), states, np.array([0.25, 3.0]))
    other = LearnedPredictor(calibrated(weights, factors))
    wider = last_prediction(other, states, np.array([0.25, 3.0]))
    np.testing.assert_array_equal(plain.positions, wider.positions)
    ratio = wider.deviations / plain.deviations
    np.testing.assert_allclose(ratio[:, :, 0], 0.5, rtol=1e-5)
    np.testing.assert_allclose(ratio[:, :, 1], 2.0, rtol=1e-5)


def test_deviations_of_a_gaussian_are_left_and_halves_are_doubled():
    draws = np.random.default_rng(0).standard_normal((20_000, STEPS, 2))
    np.testing.assert_allclose(calibration(np.abs(draws)), 1.0, atol=0.03)
    np.testing.assert_allclose(calibration(2.0 * np.abs(draws)), 2.0, atol=0.06)


def test_training_judges_the_residuals_that_inference_places():
    outputs = np.random.default_rng(0).normal(scale=0.3, size=(6, OUTPUTS)).astype(np.float32)
    expected = believed(torch.from_numpy(outputs)).numpy() * SCALE[:, None]
    people = np.stack([np.zeros(6, int), np.arange(6)], axis=1)
    frames = np.tile([1.0, 0.0], (6, 1))
    times = 0.25 * np.arange(1, STEPS + 1)
    positions, deviations = np.zeros((1, STEPS, 6, 2)), np.zeros((1, STEPS, 6))
    place(outputs, people, frames, np.zeros((1, 6, 2)), times, positions, deviations)
    np.testing.assert_allclose(positions[0].swapaxes(0, 1), expected, atol=1e-6)


def test_what_is_hardly_said_is_not_believed():
    outputs = torch.zeros(2, OUTPUTS)
    outputs[0, 0], outputs[1, 0] = 0.01, 1.0
    found = believed(outputs)[:, 0, 0]
    assert found[0] < 2e-4 and found[1] > 0.98


def test_features_are_finite_and_as_many_as_the_network_takes():
    network = build_network(16, 0)
    assert network[0].in_features == INPUTS
    prediction = last_prediction(
        LearnedPredictor(inference_weights(network)), sequence(random_state(5)), TIMES
    )
    assert np.isfinite(prediction.positions).all()
