"""Laws of the folding of constant features."""

import numpy as np
import pytest
import torch

from socialnav_core.policies import Gat4snValueNetwork, SarlValueNetwork
from socialnav_core.states import Observation
from socialnav_core.training.constant_features import without_constant_features
from socialnav_core.training.replay_buffer import ReplayBuffer

NETWORKS = [SarlValueNetwork, Gat4snValueNetwork]
RADIUS, RADIUS_SUM = 4, 6


def states(count=20, agents=3):
    """Return random states in which all radii are alike and the last agent is padding."""
    draws = np.random.default_rng(0)
    robot = draws.normal(size=(count, 6)).astype(np.float32)
    robot[:, 3] = 0.3
    others = draws.normal(size=(count, agents, 7)).astype(np.float32)
    others[..., RADIUS], others[..., RADIUS_SUM] = 0.3, 0.6
    mask = np.ones((count, agents), bool)
    mask[:, -1] = False
    others[:, -1] = 9.0
    return Observation(robot, others, mask)


def buffer_of(seen):
    """Return a buffer with states."""
    buffer = ReplayBuffer(len(seen.robot), seen.mask.shape[1])
    buffer.append(seen, np.zeros(len(seen.robot), np.float32))
    return buffer


def values(network, seen):
    """Return the values of states."""
    with torch.no_grad():
        arrays = (seen.robot, seen.others, seen.mask)
        return network(*(torch.from_numpy(array) for array in arrays)).numpy()


@pytest.mark.parametrize('kind', NETWORKS)
def test_values_of_states_seen_in_training_do_not_change(kind):
    network, seen = kind(), states()
    folded = without_constant_features(network, buffer_of(seen))
    np.testing.assert_allclose(values(folded, seen), values(network, seen), atol=1e-6)


@pytest.mark.parametrize('kind', NETWORKS)
def test_feature_that_never_varied_has_no_influence(kind):
    seen = states()
    folded = without_constant_features(kind(), buffer_of(seen))
    before = values(folded, seen)
    seen.others[..., RADIUS] += 1.2
    seen.others[..., RADIUS_SUM] += 1.2
    np.testing.assert_array_equal(values(folded, seen), before)


@pytest.mark.parametrize('kind', NETWORKS)
def test_feature_that_varied_keeps_its_weights(kind):
    network, seen = kind(), states()
    seen.others[0, 0, RADIUS] = 0.5
    folded = without_constant_features(network, buffer_of(seen))
    layer = 'mlp1.0.weight' if kind is SarlValueNetwork else 'other_mlp.0.weight'
    column = -7 + RADIUS
    weights = [each.state_dict()[layer][:, column] for each in (network, folded)]
    assert weights[0].equal(weights[1]) and weights[0].any()


def test_network_itself_is_left_as_it_is():
    network = SarlValueNetwork()
    before = {name: tensor.clone() for name, tensor in network.state_dict().items()}
    without_constant_features(network, buffer_of(states()))
    assert all(tensor.equal(before[name]) for name, tensor in network.state_dict().items())
