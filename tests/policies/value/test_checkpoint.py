"""Laws of checkpoints on disk."""

import pickle

import numpy as np
import pytest
import torch

from socialnav_core.config import Config, ConfigError, PolicyConfig
from socialnav_core.policies import build_network, CheckpointError, load_policy
from socialnav_core.policies.value.checkpoint import (
    CONFIG,
    load_checkpoint,
    save_weights,
    WEIGHTS,
)
from socialnav_core.simulation import make_scenario, Simulator


@pytest.fixture(params=['sarl', 'gat4sn'])
def saved(request, tmp_path):
    torch.manual_seed(3)
    config = Config('tiny', make_scenario('simple'), PolicyConfig(request.param, heads=2))
    network = build_network(config.policy)
    save_weights(tmp_path / 'tiny', network, config)
    return tmp_path / 'tiny', network, config


def test_save_and_load_give_the_same_weights_config_and_actions(saved):
    folder, network, config = saved
    loaded, loaded_config, _ = load_checkpoint(folder)
    assert loaded_config == config
    for name, value in network.state_dict().items():
        assert torch.equal(value, loaded.state_dict()[name])
    state = Simulator(config.scenario, 4).reset()
    assert np.isfinite(load_policy(folder).act(state)).all()


@pytest.mark.parametrize('share', [0.0, 0.3, 0.999])
def test_truncated_weights_are_refused(saved, share):
    folder, _, _ = saved
    data = (folder / WEIGHTS).read_bytes()
    (folder / WEIGHTS).write_bytes(data[: int(share * len(data))])
    with pytest.raises(CheckpointError, match='cannot be read'):
        load_checkpoint(folder)


def test_one_altered_bit_is_noticed(saved):
    folder, _, _ = saved
    data = bytearray((folder / WEIGHTS).read_bytes())
    data[-5] ^= 1
    (folder / WEIGHTS).write_bytes(bytes(data))
    with pytest.raises(CheckpointError, match='altered'):
        load_checkpoint(folder)


def test_an_altered_config_is_noticed(saved):
    folder, _, _ = saved
    text = (folder / CONFIG).read_text()
    (folder / CONFIG).write_text(text.replace('time_step: 0.25', 'time_step: 0.5'))
    with pytest.raises(CheckpointError, match='altered'):
        load_checkpoint(folder)


def test_a_pickle_in_disguise_is_refused_and_not_run(saved, tmp_path):
    folder, _, _ = saved
    trap = tmp_path / 'sprung'

    class Trap:
        def __reduce__(self):
            return (open, (str(trap), 'w'))

    (folder / WEIGHTS).write_bytes(pickle.dumps(Trap()))
    with pytest.raises(CheckpointError):
        load_checkpoint(folder)
    torch.save({'weight': Trap()}, folder / WEIGHTS)
    with pytest.raises(CheckpointError):
        load_checkpoint(folder)
    assert not trap.exists()


def test_weights_of_another_network_are_refused(saved, tmp_path):
    folder, _, config = saved
    other = PolicyConfig('gat4sn' if config.policy.network == 'sarl' else 'sarl')
    save_weights(tmp_path / 'other', build_network(other), config)
    with pytest.raises(CheckpointError, match='does not hold the network'):
        load_checkpoint(tmp_path / 'other')


def test_values_that_are_not_finite_are_refused(saved):
    folder, network, config = saved
    with torch.no_grad():
        next(network.parameters()).fill_(float('nan'))
    save_weights(folder, network, config)
    with pytest.raises(CheckpointError, match='finite'):
        load_checkpoint(folder)


@pytest.mark.parametrize('name', ['nonsense', '', 'a\0b', 'x' * 300])
def test_an_unknown_model_names_those_that_there_are(name):
    with pytest.raises(ConfigError, match='orca, straight_line'):
        load_policy(name)
