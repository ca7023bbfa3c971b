"""Laws of metrics and model cards."""

import dataclasses
import json

import pytest

from socialnav_core.policies.value.checkpoint import (
    checkpoint_digest,
    load_checkpoint,
    save_weights,
)
from socialnav_core.training.model_card import add_result, write_model_card
from socialnav_core.training.randomness import initial_network


def result(**changes):
    """Return an evaluation."""
    return {
        'scenario': 'hard', 'lookahead': 'constant_velocity', 'screening': False, 'seed': 0,
        'split': 'test', 'episodes': 200, 'success_rate': 0.95, 'success_interval': [0.91, 0.97],
        'collision_rate': 0.04, 'timeout_rate': 0.01, 'navigation_time_mean': 10.5,
        'cases': [{'case_index': 0}],
    } | changes  # fmt: skip


@pytest.fixture
def folder(tiny_config, tmp_path):
    """Return a checkpoint with random weights."""
    save_weights(tmp_path, initial_network(tiny_config.policy, seed=0), tiny_config)
    return tmp_path


def metrics(folder):
    """Return what metrics.json holds."""
    return json.loads((folder / 'metrics.json').read_text())


def test_result_of_the_checkpoint_as_it_is_goes_by_its_scenario(folder, tiny_config):
    add_result(folder, tiny_config, result())
    assert metrics(folder)['hard']['success_rate'] == 0.95


def test_results_with_other_settings_stand_beside_it(folder, tiny_config):
    for changes in ({}, {'lookahead': 'oracle'}, {'screening': True}):
        add_result(folder, tiny_config, result(**changes))
    assert list(metrics(folder)) == ['hard', 'hard+oracle', 'hard+screening']


def test_later_result_of_the_same_kind_replaces_the_earlier(folder, tiny_config):
    for rate in (0.5, 0.6):
        add_result(folder, tiny_config, result(success_rate=rate))
    assert [each['success_rate'] for each in metrics(folder).values()] == [0.6]


def test_single_cases_stay_out_of_the_metrics(folder, tiny_config):
    add_result(folder, tiny_config, result())
    assert 'cases' not in metrics(folder)['hard']


def test_card_states_results_with_intervals_and_the_commands_that_give_them(folder, tiny_config):
    add_result(folder, tiny_config, result(lookahead='oracle'))
    write_model_card(folder, load_checkpoint(folder))
    card = (folder / 'README.md').read_text()
    assert '0.9500 [0.9100, 0.9700]' in card and '| oracle | oracle |' in card
    assert '--scenario hard --episodes 200 --seed 0 --split test --lookahead oracle' in card


def test_card_names_parameters_and_digest(folder):
    write_model_card(folder, load_checkpoint(folder))
    card = (folder / 'README.md').read_text()
    assert '96,502 parameters' in card and checkpoint_digest(folder) in card


@pytest.mark.parametrize('network', ['gat4sn', 'gat4sn_linear', 'gat4sn_v2'])
def test_every_network_has_a_card(tiny_config, tmp_path, network):
    policy = dataclasses.replace(tiny_config.policy, network=network)
    config = dataclasses.replace(tiny_config, policy=policy)
    save_weights(tmp_path, initial_network(policy, seed=0), config)
    write_model_card(tmp_path, load_checkpoint(tmp_path))
    assert '4 heads' in (tmp_path / 'README.md').read_text()


def test_card_says_whether_features_that_never_varied_are_ignored(tiny_config, tmp_path):
    for fold in (True, False):
        training = dataclasses.replace(tiny_config.training, fold_constant_features=fold)
        config = dataclasses.replace(tiny_config, training=training)
        save_weights(tmp_path, initial_network(config.policy, seed=0), config)
        write_model_card(tmp_path, load_checkpoint(tmp_path))
        assert ('never varied' in (tmp_path / 'README.md').read_text()) == fold
