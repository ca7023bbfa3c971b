"""Laws of a planner on disk."""

import numpy as np
import pytest
import torch

from socialnav_core.config import ConfigError, make_scenario, SearchConfig
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.config.policy import PolicyConfig
from socialnav_core.policies import CheckpointError, load_policy
from socialnav_core.policies.loading import settings_of
from socialnav_core.policies.search.checkpoint import load_planner, PLANNER, save_planner
from socialnav_core.simulation import Simulator
from socialnav_core.training.randomness import initial_network

CONFIG = PlannerConfig('tiny', policy=SearchConfig(headings=8, horizon=1.0))


@pytest.fixture
def folder(tmp_path):
    save_planner(tmp_path / 'tiny', initial_network(PolicyConfig(), 1), CONFIG)
    return tmp_path / 'tiny'


def test_what_is_saved_is_loaded(folder):
    network, config, digest = load_planner(folder)
    assert config == CONFIG and len(digest) == 64
    saved = initial_network(PolicyConfig(), 1).state_dict()
    assert all(torch.equal(saved[name], value) for name, value in network.state_dict().items())


def test_a_loaded_planner_drives_by_its_settings(folder):
    policy = load_policy(folder)
    state = Simulator(make_scenario('crowd20'), 2).reset(seed=1)
    assert np.isfinite(policy.act(state)).all()
    assert policy.description.name == 'tiny'
    assert policy.plan.shape == (2, 4, 2)
    np.testing.assert_allclose(policy.attention(state).sum(axis=1), 1.0, atol=1e-5)


def test_settings_can_be_overridden(folder):
    assert load_policy(folder, horizon=2.0, value_weight=0.5).settings.horizon == 2.0
    assert 'contact' in settings_of(folder)
    with pytest.raises(ConfigError, match='heads'):
        load_policy(folder, heads=2)


def test_altered_weights_are_refused(folder):
    data = bytearray((folder / PLANNER).read_bytes())
    data[-1] ^= 1
    (folder / PLANNER).write_bytes(data)
    with pytest.raises(CheckpointError, match='altered'):
        load_policy(folder)


def test_an_altered_config_is_refused(folder):
    text = (folder / 'config.yaml').read_text()
    (folder / 'config.yaml').write_text(text.replace('network: sarl', 'network: gat4sn'))
    with pytest.raises(CheckpointError, match='altered'):
        load_policy(folder)


def test_weights_of_another_network_are_refused(folder):
    other = PlannerConfig('tiny', network='gat4sn', policy=CONFIG.policy)
    save_planner(folder, initial_network(PolicyConfig(), 1), other)
    with pytest.raises(CheckpointError, match='does not hold the network gat4sn'):
        load_planner(folder)
