"""Laws of inference from NumPy arrays."""

import copy

import numpy as np
import pytest
import torch
from torch import nn

from socialnav_core.policies.value.gat4sn import Gat4snValueNetwork
from socialnav_core.policies.value.inference import (
    BFLOAT16_CHUNK,
    chunks,
    FLOAT32_CHUNK,
    ValueInference,
)
from socialnav_core.policies.value.sarl import SarlValueNetwork
from socialnav_core.states import Observation

BUILDERS = {
    'sarl': SarlValueNetwork,
    'gat4sn': lambda: Gat4snValueNetwork(heads=4),
    'gat4sn-gatv2': lambda: Gat4snValueNetwork(heads=2, score='gatv2'),
}
Arrays = tuple[np.ndarray, np.ndarray, np.ndarray]
ACTIONS = 17


@pytest.fixture(params=BUILDERS)
def network(request) -> nn.Module:
    torch.manual_seed(0)
    return BUILDERS[request.param]()


def _arrays(rows: int, agents: int = 5, seed: int = 0) -> Arrays:
    generator = np.random.default_rng(seed)
    robot = generator.normal(size=(rows, 6)).astype(np.float32)
    others = generator.normal(scale=3.0, size=(rows, agents, 7)).astype(np.float32)
    return robot, others, generator.random((rows, agents)) < 0.7


def _decisions(decisions: int) -> Arrays:
    """Return rows of which 17 at a time differ as the actions of one decision do."""
    generator = np.random.default_rng(1)
    robot, others, mask = (np.repeat(array, ACTIONS, axis=0) for array in _arrays(decisions))
    angle = generator.uniform(-np.pi, np.pi, size=len(robot))
    speed = generator.choice([0.38, 1.0], size=len(robot))
    velocity = speed[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    robot[:, 0] -= 0.25 * velocity[:, 0]
    robot[:, 4:6] = velocity
    others[:, :, :2] -= 0.25 * velocity[:, None]
    others[:, :, 5] = np.linalg.norm(others[:, :, :2], axis=2)
    return robot, others, mask


def _forward(network: nn.Module, arrays: Arrays) -> np.ndarray:
    with torch.no_grad():
        return network(*(torch.from_numpy(array) for array in arrays)).numpy()


@pytest.mark.parametrize(
    'rows', [0, 1, ACTIONS, FLOAT32_CHUNK, FLOAT32_CHUNK + 1, 3 * FLOAT32_CHUNK - 7]
)
def test_values_are_those_of_forward_for_any_number_of_rows(network, rows):
    arrays = _arrays(rows)
    values = ValueInference(network).values(*arrays)
    assert values.dtype == np.float32
    np.testing.assert_allclose(values, _forward(network, arrays), rtol=0, atol=1e-5)


def test_values_without_agents_are_those_of_forward(network):
    arrays = _arrays(ACTIONS, agents=0)
    values = ValueInference(network).values(*arrays)
    np.testing.assert_allclose(values, _forward(network, arrays), rtol=0, atol=1e-5)


def test_values_follow_a_step_of_the_optimizer(network):
    inference, arrays = ValueInference(network), _arrays(ACTIONS)
    before = inference.values(*arrays)
    optimizer = torch.optim.Adam(network.parameters(), lr=0.01)
    network(*(torch.from_numpy(array) for array in arrays)).sum().backward()
    optimizer.step()
    assert not np.allclose(inference.values(*arrays), before, atol=1e-3)
    np.testing.assert_allclose(
        inference.values(*arrays), _forward(network, arrays), rtol=0, atol=1e-5
    )


@pytest.mark.parametrize('assign', ['in place', 'new memory'])
def test_values_follow_weights_that_are_loaded(network, assign):
    inference, arrays = ValueInference(network), _arrays(ACTIONS)
    before = inference.values(*arrays)
    other = copy.deepcopy(network)
    for parameter in other.parameters():
        nn.init.normal_(parameter, std=0.1)
    if assign == 'in place':
        network.load_state_dict(other.state_dict())
    else:
        for parameter, source in zip(network.parameters(), other.parameters(), strict=True):
            parameter.data = source.data.clone()
    assert not np.allclose(inference.values(*arrays), before, atol=1e-3)
    np.testing.assert_allclose(
        inference.values(*arrays), _forward(other, arrays), rtol=0, atol=1e-5
    )


def test_network_can_be_trained_between_values(network):
    inference, arrays = ValueInference(network), _arrays(ACTIONS)
    inference.values(*arrays)
    network(*(torch.from_numpy(array) for array in arrays)).sum().backward()
    assert all(parameter.grad is not None for parameter in network.parameters())


def test_small_batches_stay_in_float32_when_bfloat16_is_asked_for(network):
    arrays = _arrays(ACTIONS)
    low = ValueInference(network, bfloat16=True).values(*arrays)
    np.testing.assert_array_equal(low, ValueInference(network).values(*arrays))


def test_large_batches_in_bfloat16_come_near_float32_without_equalling_it(network):
    arrays = _arrays(2 * BFLOAT16_CHUNK + 100)
    full = ValueInference(network).values(*arrays)
    low = ValueInference(network, bfloat16=True).values(*arrays)
    assert low.dtype == np.float32
    assert 0.0 < np.abs(low - full).max() < 0.05 * np.abs(full).max()


@pytest.mark.parametrize(('name', 'share'), [('sarl', 0.96), ('gat4sn', 0.88)])
def test_bfloat16_chooses_mostly_the_action_of_float32_and_never_a_much_worse_one(name, share):
    torch.manual_seed(0)
    network, arrays = BUILDERS[name](), _decisions(1000)
    full = ValueInference(network).values(*arrays).reshape(-1, ACTIONS)
    low = ValueInference(network, bfloat16=True).values(*arrays).reshape(-1, ACTIONS)
    chosen = low.argmax(axis=1)
    assert np.mean(chosen == full.argmax(axis=1)) >= share
    loss = full.max(axis=1) - full[np.arange(len(full)), chosen]
    assert loss.max() < 0.1 * np.ptp(full, axis=1).mean()


def test_attention_is_that_of_the_network(network):
    robot, others, mask = _arrays(3)
    attention = ValueInference(network).attention(Observation(robot, others, mask))
    assert attention.shape == mask.shape
    np.testing.assert_allclose(attention.sum(axis=1), mask.any(axis=1), atol=1e-5)


@pytest.mark.parametrize('bfloat16', [False, True])
@pytest.mark.parametrize('rows', [1, 127, 128, 256, 512, 513, 700, 2176])
def test_chunks_cover_every_row(rows, bfloat16):
    covered = np.concatenate([np.arange(rows)[chunk] for chunk in chunks(rows, bfloat16)])
    assert np.array_equal(np.unique(covered), np.arange(rows))


def test_chunks_in_bfloat16_have_few_different_lengths():
    lengths = {c.stop - c.start for rows in range(512, 4096) for c in chunks(rows, bfloat16=True)}
    assert lengths == {128, 256, 384, 512}
