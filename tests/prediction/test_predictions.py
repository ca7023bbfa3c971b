"""Laws of predictions: what each member says, and how one is added."""

import dataclasses

import numpy as np
import pytest
import torch

from socialnav_core.config import Config, ConfigError, PolicyConfig
from socialnav_core.evaluation import evaluate
from socialnav_core.policies import build_network, load_policy
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.prediction import make_predictor, Oracle, Prediction, PREDICTIONS
from socialnav_core.prediction.one_step import one_step
from socialnav_core.prediction.oracle import attach_simulator
from socialnav_core.simulation import make_scenario, Simulator

TIMES = np.array([0.25, 0.5, 1.0])
HARD = make_scenario('hard')


class Standing:
    """Everybody stops at once: a prediction as others may add one, with a count of resets."""

    knowledge = 'model-matched'
    remembers = True

    def __init__(self):
        self.asked, self.forgotten = [], []

    def predict(self, state, times):
        self.asked.append(state.batch_size)
        steps = (state.batch_size, 1, len(times), state.agents.count)
        positions = np.broadcast_to(state.agents.position[:, None, None], (*steps, 2))
        return Prediction(positions, np.full(steps, 0.1), np.ones((state.batch_size, 1)))

    def reset(self, worlds=None):
        self.forgotten.append(worlds)


@pytest.fixture(scope='module')
def checkpoint(tmp_path_factory):
    """Return a checkpoint with random weights."""
    folder, policy = tmp_path_factory.mktemp('checkpoint'), PolicyConfig()
    torch.manual_seed(0)
    save_weights(folder, build_network(policy), Config('untrained', HARD, policy=policy))
    return folder


def worlds(steps=3):
    """Return a simulator and its state, people under way."""
    simulator = Simulator(HARD, 5)
    state = simulator.reset(seed=2)
    for _ in range(steps):
        state = simulator.step(np.zeros((5, 2)))[0]
    return simulator, state


@pytest.mark.parametrize('name', PREDICTIONS)
def test_every_prediction_has_the_shapes_of_the_protocol(name):
    simulator, state = worlds()
    predictor = make_predictor(name)
    attach_simulator(predictor, simulator.next_agent_velocities)
    predicted = predictor.predict(state, TIMES)
    batch, modes, steps, agents, axes = predicted.positions.shape
    assert (batch, steps, agents, axes) == (5, 3, state.agents.count, 2)
    assert predicted.deviations.shape == (batch, modes, steps, agents)
    np.testing.assert_allclose(predicted.weights.sum(axis=1), 1.0)
    assert predictor.knowledge in ('deployable', 'model-matched', 'oracle')


def test_constant_velocity_takes_everybody_straight_on_and_knows_less_the_later():
    _, state = worlds()
    predicted = make_predictor('constant_velocity').predict(state, TIMES)
    moved = predicted.positions[:, 0] - state.agents.position[:, None]
    np.testing.assert_allclose(moved, TIMES[:, None, None] * state.agents.velocity[:, None])
    walking = np.linalg.norm(state.agents.velocity, axis=-1) > 0.1
    assert walking.any()
    assert (np.diff(predicted.deviations[:, 0], axis=1).transpose(0, 2, 1)[walking] > 0).all()


def test_the_oracle_says_where_the_simulator_then_takes_people():
    simulator, state = worlds()
    predicted = Oracle(simulator.next_agent_velocities).predict(state, TIMES[:1])
    after = simulator.step(np.zeros((5, 2)))[4]['final_state']
    real = state.agents.valid
    expected = after.agents.position[real]
    np.testing.assert_allclose(predicted.positions[:, 0, 0][real], expected, atol=1e-12)
    assert not predicted.deviations.any()


def test_the_oracle_needs_a_simulator():
    with pytest.raises(ConfigError, match='constant_velocity'):
        Oracle().predict(worlds()[1], TIMES)


def test_an_unknown_prediction_is_answered_with_those_that_there_are():
    with pytest.raises(ConfigError, match='constant_velocity, learned, oracle'):
        make_predictor('psychic')


def test_one_step_keeps_the_bits_of_the_velocities_that_a_prediction_tells():
    _, state = worlds()
    predicted = make_predictor('constant_velocity').predict(state, TIMES[:1])
    velocities, _ = one_step(predicted, state, TIMES[0])
    np.testing.assert_array_equal(velocities, state.agents.velocity)


def test_one_step_finds_the_velocities_that_lead_to_positions():
    _, state = worlds()
    predicted = make_predictor('constant_velocity').predict(state, TIMES[:1])
    told = dataclasses.replace(predicted, velocities=None)
    velocities, deviations = one_step(told, state, TIMES[0])
    np.testing.assert_allclose(velocities, state.agents.velocity, atol=1e-12)
    np.testing.assert_array_equal(deviations, predicted.deviations[:, 0, 0])


def test_one_step_takes_modes_together_as_their_mixture():
    _, state = worlds()
    generator = np.random.default_rng(0)
    shape = (5, 2, 1, state.agents.count)
    offset = generator.normal(size=(*shape, 2))
    weights = np.tile([0.25, 0.75], (5, 1))
    positions = state.agents.position[:, None, None] + offset
    predicted = Prediction(positions, np.full(shape, 0.1), weights)
    velocities, deviations = one_step(predicted, state, 0.5)
    mean = 0.25 * offset[:, 0, 0] + 0.75 * offset[:, 1, 0]
    np.testing.assert_allclose(velocities, mean / 0.5, atol=1e-12)
    apart = 0.25 * 0.75 * np.square(offset[:, 0, 0] - offset[:, 1, 0]).mean(axis=-1)
    np.testing.assert_allclose(deviations, np.sqrt(0.1**2 + apart))


def test_a_prediction_is_added_by_a_line_of_the_table(monkeypatch, checkpoint):
    monkeypatch.setitem(PREDICTIONS, 'standing', Standing)
    policy = load_policy(checkpoint, lookahead='standing')
    values = evaluate(policy, HARD, 3).to_mapping()
    assert (values['lookahead'], values['knowledge']) == ('standing', 'model-matched')


def test_a_prediction_with_a_history_keeps_its_rows_and_hears_of_new_episodes(
    monkeypatch, checkpoint
):
    monkeypatch.setitem(PREDICTIONS, 'standing', Standing)
    policy = load_policy(checkpoint, lookahead='standing')
    evaluate(policy, HARD, 7, batch_size=3)
    assert set(policy.predictor.asked) == {3}
    first, *later = policy.predictor.forgotten
    assert first is None and sum(map(len, later)) == 7
