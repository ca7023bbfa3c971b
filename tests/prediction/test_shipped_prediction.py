"""Laws of the prediction that ships."""

from crowd_states import last_prediction
import numpy as np
import pytest

from socialnav_core.config import make_scenario
from socialnav_core.evaluation.prediction import evaluate_prediction
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


def test_its_card_names_its_weights():
    folder = find_predictor('prediction')
    assert arrays_digest(load_weights(folder)[0]) in (folder / 'README.md').read_text()
    assert (folder / WEIGHTS).stat().st_size < 1e6
