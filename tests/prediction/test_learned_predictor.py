"""Laws of the learned prediction; they hold for any weights."""

from crowd_states import last_prediction, moved, random_predictor, random_state, sequence, TIMES
import numpy as np
import pytest
import torch

from socialnav_core.prediction.learned import LearnedPredictor
from socialnav_core.prediction.learned.features import person_features
from socialnav_core.prediction.learned.layout import INPUTS, MOTION, OUTPUTS
from socialnav_core.prediction.learned.network import Layers
from socialnav_core.prediction.protocol import Predictor
from socialnav_core.training.prediction.network import build_network, inference_weights


@pytest.fixture(scope='module')
def predictor():
    return random_predictor()


def assert_same(first, second, tolerance=1e-4):
    np.testing.assert_allclose(first.positions, second.positions, atol=tolerance)
    np.testing.assert_allclose(first.deviations, second.deviations, atol=tolerance)


def test_it_is_a_predictor_that_a_robot_may_use(predictor):
    checked: Predictor = predictor
    assert checked.knowledge == 'deployable' and checked.remembers


def test_shapes_are_those_of_the_protocol_and_weights_sum_to_one(predictor):
    prediction = last_prediction(predictor, [random_state(5)])
    assert prediction.positions.shape == (2, 1, len(TIMES), 7, 2)
    assert prediction.deviations.shape == (2, 1, len(TIMES), 7)
    np.testing.assert_array_equal(prediction.weights.sum(axis=1), 1.0)


def test_it_turns_with_the_world(predictor):
    angle = 0.7
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    states = sequence(random_state(6))
    turned = [
        state.with_agents(
            position=state.agents.position @ turn, velocity=state.agents.velocity @ turn
        )
        for state in states
    ]
    plain, other = last_prediction(predictor, states), last_prediction(predictor, turned)
    np.testing.assert_allclose(plain.positions @ turn, other.positions, atol=1e-4)
    np.testing.assert_allclose(plain.deviations, other.deviations, atol=1e-4)


def test_it_turns_with_the_world_where_everybody_stands(predictor):
    turn = np.array([[0.0, 1.0], [-1.0, 0.0]])
    state = random_state(6)
    state = state.with_agents(velocity=np.zeros_like(state.agents.velocity))
    turned = state.with_agents(position=state.agents.position @ turn)
    plain, other = last_prediction(predictor, [state]), last_prediction(predictor, [turned])
    np.testing.assert_allclose(plain.positions @ turn, other.positions, atol=1e-4)


def test_it_moves_with_the_world(predictor):
    shift = np.array([30.0, -20.0])
    states = sequence(random_state(6))
    shifted = [state.with_agents(position=state.agents.position + shift) for state in states]
    plain, other = last_prediction(predictor, states), last_prediction(predictor, shifted)
    np.testing.assert_allclose(plain.positions + shift, other.positions, atol=1e-4)


def test_permuted_agents_have_permuted_predictions(predictor):
    order = np.random.default_rng(1).permutation(8)
    states = sequence(random_state(6))
    permuted = [
        state.with_agents(**{name: array[:, order] for name, array in vars(state.agents).items()})
        for state in states
    ]
    plain, other = last_prediction(predictor, states), last_prediction(predictor, permuted)
    np.testing.assert_allclose(plain.positions[:, :, :, order], other.positions, atol=1e-4)
    np.testing.assert_allclose(plain.deviations[..., order], other.deviations, atol=1e-4)


def test_padding_changes_nothing(predictor):
    states = sequence(random_state(5))
    junk = random_state(3, obstacles=0, seed=9).agents
    junk.position[:], junk.velocity[:], junk.valid[:] = np.nan, np.nan, False
    padded = [state.with_agents(**vars(state.agents.append(junk))) for state in states]
    plain, other = last_prediction(predictor, states), last_prediction(predictor, padded)
    np.testing.assert_allclose(plain.positions, other.positions[:, :, :, :7], atol=1e-6)
    np.testing.assert_allclose(plain.deviations, other.deviations[..., :7], atol=1e-6)


def test_obstacles_stay_where_they_are_to_a_millimetre(predictor):
    state = random_state(4, obstacles=3)
    prediction = last_prediction(predictor, [state])
    there = state.agents.position[:, None, None, 4:]
    np.testing.assert_array_equal(prediction.positions[:, :, :, 4:] - there, 0.0)
    np.testing.assert_array_equal(prediction.deviations[..., 4:], 0.001)


def test_the_compiled_network_computes_what_torch_does():
    network = build_network(192, seed=3)
    inputs = np.random.default_rng(0).normal(size=(40, INPUTS)).astype(np.float32)
    with torch.inference_mode():
        expected = network(torch.from_numpy(inputs))[:, :OUTPUTS].numpy()
    np.testing.assert_allclose(Layers(inference_weights(network))(inputs), expected, atol=1e-4)


def test_the_history_of_one_world_is_not_anothers(predictor):
    states = sequence(random_state(5))
    both = last_prediction(predictor, states)
    for world in range(2):
        alone = last_prediction(predictor, [state.select(np.array([world])) for state in states])
        np.testing.assert_allclose(both.positions[[world]], alone.positions, atol=1e-5)


def test_history_matters(predictor):
    states = sequence(random_state(5))
    with_past, without = (
        last_prediction(predictor, states),
        last_prediction(predictor, states[-1:]),
    )
    assert np.abs(with_past.positions - without.positions).max() > 1e-3


def test_who_asks_twice_is_told_the_same(predictor):
    states = sequence(random_state(5))
    first = last_prediction(predictor, states)
    assert_same(first, predictor.predict(states[-1], TIMES), tolerance=0)


def test_a_jump_back_of_time_forgets(predictor):
    states = sequence(random_state(5))
    again = states[0]
    fresh = last_prediction(predictor, [again])
    assert_same(fresh, last_prediction(predictor, [*states, again]), tolerance=0)


def test_a_reset_forgets_the_worlds_that_are_named_and_no_others(predictor):
    states = sequence(random_state(5))
    known, fresh = last_prediction(predictor, states), last_prediction(predictor, states[-1:])
    last_prediction(predictor, states[:-1])
    predictor.reset(np.array([1]))
    mixed = predictor.predict(states[-1], TIMES)
    np.testing.assert_array_equal(mixed.positions[0], known.positions[0])
    np.testing.assert_array_equal(mixed.positions[1], fresh.positions[1])


def test_agents_that_change_slots_are_predicted_as_before(predictor):
    states = sequence(random_state(5, obstacles=0))
    plain = last_prediction(predictor, states)
    order = np.array([3, 0, 4, 1, 2])
    last = states[-1].with_agents(
        **{name: array[:, order] for name, array in vars(states[-1].agents).items()}
    )
    other = last_prediction(predictor, [*states[:-1], last])
    np.testing.assert_allclose(plain.positions[:, :, :, order], other.positions, atol=1e-4)


def test_who_appears_has_no_history_though_others_have(predictor):
    states = sequence(random_state(3, obstacles=0))
    short = [state.with_agents(valid=state.agents.valid & [True, True, False]) for state in states]
    appeared = last_prediction(predictor, [*short[:-1], states[-1]])
    lagged, known = predictor.history.lagged()
    np.testing.assert_array_equal(known[0, :, 2], [True] + [False] * 5)
    assert known[0, :4, 0].all() and np.isfinite(appeared.positions).all()


@pytest.mark.parametrize('people', [0, 1, 150])
def test_any_number_of_people_is_predicted(predictor, people):
    prediction = last_prediction(predictor, sequence(random_state(people, obstacles=0)))
    assert prediction.positions.shape[3] == people
    assert np.isfinite(prediction.positions).all() and (prediction.deviations > 0).all()


def test_people_in_the_same_place_who_stand_are_predicted(predictor):
    state = random_state(4, obstacles=1)
    state.agents.position[:], state.agents.velocity[:] = 1.0, 0.0
    prediction = last_prediction(predictor, [state, moved(state)])
    assert np.isfinite(prediction.positions).all()
    assert np.isfinite(prediction.deviations).all()


def test_a_prediction_begins_where_people_are(predictor):
    state = random_state(4, obstacles=0)
    prediction = last_prediction(predictor, [state], times=np.array([0.0]))
    np.testing.assert_allclose(prediction.positions[:, 0, 0], state.agents.position)
    np.testing.assert_array_equal(prediction.deviations, 0.001)


def test_times_between_the_networks_moments_lie_between_them(predictor):
    states, times = sequence(random_state(4)), np.array([0.5, 0.6, 0.75])
    at = last_prediction(predictor, states, times)
    mixed = 0.6 * at.positions[:, :, 0] + 0.4 * at.positions[:, :, 2]
    np.testing.assert_allclose(at.positions[:, :, 1], mixed, atol=1e-9)


def test_features_of_who_is_predicted_come_in_the_order_of_slots():
    agents = random_state(3, obstacles=1).agents
    lagged, known = np.zeros((2, 6, 4, MOTION)), np.zeros((2, 6, 4), bool)
    people, features, frames = person_features(
        agents.position, lagged, known, agents.radius, agents.static, agents.valid
    )
    expected = [[world, slot] for world in range(2) for slot in range(3)]
    np.testing.assert_array_equal(people, expected)
    np.testing.assert_allclose(np.hypot(frames[:, 0], frames[:, 1]), 1.0)


def test_zero_weights_predict_constant_velocity():
    weights = inference_weights(build_network(32, 0))
    constant = LearnedPredictor({name: 0.0 * array for name, array in weights.items()})
    state = random_state(4)
    expected = state.agents.position[:, None] + (
        state.agents.velocity[:, None] * TIMES[:, None, None]
    )
    found = last_prediction(constant, [state]).positions[:, 0]
    np.testing.assert_allclose(found, expected, atol=1e-12)
