"""Laws of training the prediction."""

import dataclasses
import shutil

from crowd_states import last_prediction, random_state, sequence
import numpy as np
import pytest
import torch

from socialnav_core.config import ConfigError
from socialnav_core.config.prediction import (
    CrowdsConfig,
    PredictionConfig,
    PredictionTrainingConfig,
)
from socialnav_core.config.reading import read_prediction_config
from socialnav_core.prediction.learned import LearnedPredictor, load_predictor
from socialnav_core.prediction.learned.checkpoint import load_weights, WEIGHTS
from socialnav_core.storage import arrays_digest, CheckpointError
from socialnav_core.training.prediction import learning, train_prediction
from socialnav_core.training.resume import FINISHED_NAME

torch.set_num_threads(1)

TINY = PredictionConfig(
    'tiny',
    crowds=CrowdsConfig(groups=3, validation_groups=2, worlds=2, duration=5.0),
    training=PredictionTrainingConfig(
        updates=6, validation_updates=2, recordings_per_update=2, moments_per_recording=3, width=16
    ),
)


def digest_of(folder):
    """Return the digest of the weights in a folder."""
    return arrays_digest(load_weights(folder)[0])


def train(folder, config=TINY, **options):
    """Train in a folder; return the digest of the weights."""
    train_prediction(config, folder, progress=False, **options)
    return digest_of(folder)


@pytest.fixture(scope='module')
def trained(tmp_path_factory):
    folder = tmp_path_factory.mktemp('runs') / 'tiny'
    train(folder)
    return folder


def test_a_run_leaves_a_checkpoint_and_the_state_to_make_it_longer(trained):
    names = {path.name for path in trained.iterdir()}
    assert names == {WEIGHTS, 'config.yaml', 'progress.csv', FINISHED_NAME}


def test_the_same_seed_gives_the_same_weights_and_another_one_others(trained, tmp_path):
    assert train(tmp_path / 'same') == digest_of(trained)
    assert train(tmp_path / 'other', dataclasses.replace(TINY, seed=1)) != digest_of(trained)


@pytest.mark.parametrize('iterations', [0, 1, 2])
def test_a_resumed_run_ends_with_the_weights_of_an_uninterrupted_one(
    trained, tmp_path, monkeypatch, iterations
):
    original = learning.iterate

    def die_at(run):
        if run.updates == 2 * iterations:
            raise RuntimeError('killed')
        return original(run)

    with monkeypatch.context() as patch:
        patch.setattr(learning, 'iterate', die_at)
        with pytest.raises(RuntimeError, match='killed'):
            train(tmp_path / 'cut')
    assert train(tmp_path / 'cut', resume=True) == digest_of(trained)
    rows = [(tmp_path / 'cut' / 'progress.csv'), trained / 'progress.csv']
    assert len({len(path.read_text().splitlines()) for path in rows}) == 1


def test_a_run_is_resumed_with_its_own_settings_only(tmp_path, monkeypatch):
    monkeypatch.setattr(learning, 'iterate', lambda run: exec('raise RuntimeError'))
    with pytest.raises(RuntimeError):
        train(tmp_path / 'cut')
    other = dataclasses.replace(TINY, seed=5)
    with pytest.raises(ConfigError, match='seed = 0, not 5'):
        train(tmp_path / 'cut', other, resume=True)


def test_training_makes_the_loss_smaller(tmp_path):
    training = dataclasses.replace(
        TINY.training, updates=200, validation_updates=50, learning_rate=1e-2
    )
    train(tmp_path / 'run', dataclasses.replace(TINY, training=training))
    rows = np.genfromtxt(tmp_path / 'run' / 'progress.csv', delimiter=',', names=True)
    assert rows['loss'][-1] < rows['loss'][0] - 0.5


def test_what_is_loaded_predicts_what_was_saved(trained):
    states = sequence(random_state(4))
    saved = last_prediction(LearnedPredictor(load_weights(trained)[0]), states)
    loaded = last_prediction(load_predictor(trained), states)
    np.testing.assert_array_equal(saved.positions, loaded.positions)
    np.testing.assert_array_equal(saved.deviations, loaded.deviations)


@pytest.mark.parametrize('name', [WEIGHTS, 'config.yaml'])
def test_an_altered_checkpoint_is_refused(trained, tmp_path, name):
    for path in trained.iterdir():
        (tmp_path / path.name).write_bytes(path.read_bytes())
    data = bytearray((tmp_path / name).read_bytes())
    data[-2] ^= 1
    (tmp_path / name).write_bytes(bytes(data))
    with pytest.raises(CheckpointError):
        load_weights(tmp_path)


def test_an_absent_model_is_an_error_that_says_how_to_make_one(tmp_path):
    with pytest.raises(ConfigError, match='train-prediction'):
        load_predictor(tmp_path / 'nothing')


def test_the_configuration_that_comes_with_the_package_is_read_and_changed():
    config = read_prediction_config('mixed', {'training.updates': 7, 'crowds.mixture.varied': 0.5})
    assert (config.name, config.training.updates) == ('prediction', 7)
    assert config.crowds.mixture.varied == 0.5


def test_an_unknown_setting_names_the_nearest():
    with pytest.raises(ConfigError, match='did you mean updates'):
        read_prediction_config('mixed', {'training.update': 7})


def test_a_training_that_would_not_fit_into_memory_is_refused_before_it_begins(tmp_path):
    crowds = dataclasses.replace(TINY.crowds, groups=100_000, worlds=4096, duration=600.0)
    with pytest.raises(ConfigError, match='GiB'):
        train_prediction(dataclasses.replace(TINY, crowds=crowds), tmp_path / 'run')
    assert not (tmp_path / 'run').exists()


def test_a_finished_run_goes_on_when_it_is_made_longer(trained, tmp_path):
    folder = tmp_path / 'tiny'
    shutil.copytree(trained, folder)
    with pytest.raises(ConfigError, match='finished after training.updates = 6.*=12'):
        train_prediction(TINY, folder, resume=True, progress=False)
    longer = dataclasses.replace(TINY.training, updates=8)
    train_prediction(dataclasses.replace(TINY, training=longer), folder, resume=True)
    rows = (folder / 'progress.csv').read_text().splitlines()
    assert [row.partition(',')[0] for row in rows[1:]] == ['2', '4', '6', '8']
