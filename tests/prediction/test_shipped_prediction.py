"""Laws of the prediction that ships."""

import dataclasses

from crowd_states import last_prediction
import numpy as np
import pytest

from socialnav_core.config import make_scenario
from socialnav_core.evaluation.judgement import judge, summarise
from socialnav_core.evaluation.prediction import evaluate_prediction, recorded_moments
from socialnav_core.prediction.learned import load_predictor
from socialnav_core.prediction.learned.checkpoint import find_predictor, load_weights, WEIGHTS
from socialnav_core.storage import arrays_digest
from socialnav_core.training.prediction.crowds import Crowd, record


@pytest.fixture(scope='module')
def predictor():
    return load_predictor()


@pytest.mark.parametrize('crowd', ['crowd20', 'hard', 'packed-2.5'])
def test_it_predicts_better_than_constant_velocity(predictor, crowd):
    (result,) = evaluate_prediction(predictor, crowd, groups=1, split='validation')
    assert (np.array(result.error) < 0.95 * np.array(result.constant_velocity)).all()


def test_most_errors_lie_within_two_deviations_even_with_noise(predictor):
    (result,) = evaluate_prediction(predictor, 'crowd20', 1, 0, 'validation', noise=True)
    assert min(result.within_two) > 0.7


def test_it_is_less_certain_of_those_who_have_no_history(predictor):
    crowd = Crowd('scenarios', make_scenario('hard'))
    recording = record(crowd, 6, 8.0, 'validation', 0, 0, np.random.default_rng(0))
    states = [recording.state(moment) for moment in range(12, 24)]
    known = last_prediction(predictor, states).deviations[..., : recording.people]
    new = last_prediction(predictor, states[-1:]).deviations[..., : recording.people]
    assert (new.mean(axis=(0, 1, 3)) > known.mean(axis=(0, 1, 3))).all()


def test_it_is_as_near_as_constant_velocity_where_people_walk_on(predictor):
    (result,) = evaluate_prediction(predictor, 'street', 2, 0, 'validation')
    assert (np.array(result.error) < 1.02 * np.array(result.constant_velocity) + 0.005).all()


def halves(recording):
    """Return a recording of which every second moment alone is seen."""
    parts = {name: getattr(recording, name)[:, ::2] for name in ('position', 'velocity', 'goal')}
    return dataclasses.replace(recording, time_step=2.0 * recording.time_step, **parts)


def test_it_predicts_as_well_at_10_hz_as_at_5(predictor):
    scenario = dataclasses.replace(make_scenario('crowd20'), time_step=0.1)
    crowd = Crowd('scenarios', scenario)
    recording = record(crowd, 4, 12.0, 'validation', 0, 0, np.random.default_rng(0))
    often, seldom = (
        summarise(judge(predictor, [recorded_moments(seen, seen)], 'crowd20'), 'crowd20')[0]
        for seen in (recording, halves(recording))
    )
    np.testing.assert_allclose(often.error, seldom.error, rtol=0.15)
    assert (np.array(often.error) < 0.95 * np.array(often.constant_velocity)).all()


def test_a_new_track_is_uncertain_among_known_ones(predictor):
    crowd = Crowd('scenarios', make_scenario('hard'))
    recording = record(crowd, 6, 8.0, 'validation', 0, 0, np.random.default_rng(0))
    states = [recording.state(moment) for moment in range(12, 24)]
    known = last_prediction(predictor, states).deviations[..., 0]
    hidden = [state.with_agents(valid=state.agents.valid.copy()) for state in states]
    for state in hidden[:-1]:
        state.agents.valid[:, 0] = False
    new = last_prediction(predictor, hidden).deviations[..., 0]
    assert (new.mean(axis=(0, 1)) > known.mean(axis=(0, 1))).all()


def test_its_card_names_its_weights():
    folder = find_predictor('prediction')
    assert arrays_digest(load_weights(folder)[0]) in (folder / 'README.md').read_text()
    assert (folder / WEIGHTS).stat().st_size < 1e6
