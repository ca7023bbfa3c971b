"""Laws that every value network obeys."""

import pytest
import torch
from torch import nn

from socialnav_core.policies.value.gat4sn import Gat4snValueNetwork
from socialnav_core.policies.value.sarl import SarlValueNetwork

BUILDERS = {
    'sarl': SarlValueNetwork,
    'gat4sn-1': lambda: Gat4snValueNetwork(heads=1),
    'gat4sn-4': lambda: Gat4snValueNetwork(heads=4),
    'gat4sn-4-gatv2': lambda: Gat4snValueNetwork(heads=4, score='gatv2'),
}
Batch = tuple[torch.Tensor, torch.Tensor, torch.Tensor]


@pytest.fixture(params=BUILDERS)
def network(request) -> nn.Module:
    torch.manual_seed(0)
    return BUILDERS[request.param]()


@pytest.fixture
def batch() -> Batch:
    """Five samples of six agents, from all agents valid in the first to one in the last."""
    generator = torch.Generator().manual_seed(1)
    robot = torch.randn(5, 6, generator=generator)
    others = torch.randn(5, 6, 7, generator=generator)
    mask = torch.arange(6) < torch.tensor([6, 5, 4, 2, 1])[:, None]
    return robot, others, mask


def test_value_has_one_number_for_each_sample(network, batch):
    assert network(*batch).shape == (5,)


def test_permuting_the_agents_leaves_the_value_unchanged(network, batch):
    robot, others, mask = batch
    order = torch.tensor([3, 5, 0, 1, 4, 2])
    torch.testing.assert_close(
        network(robot, others[:, order], mask[:, order]), network(*batch), rtol=0, atol=1e-6
    )


def test_permuting_the_agents_permutes_the_attention_weights(network, batch):
    robot, others, mask = batch
    order = torch.tensor([3, 5, 0, 1, 4, 2])
    torch.testing.assert_close(
        network.attention_weights(robot, others[:, order], mask[:, order]),
        network.attention_weights(*batch)[:, order],
        rtol=0,
        atol=1e-6,
    )


@pytest.mark.parametrize('filling', [0.0, 1e30, float('inf'), float('nan')])
def test_padding_changes_nothing_whatever_it_holds(network, batch, filling):
    robot, others, mask = batch
    padded_others = torch.cat([others, torch.full((5, 3, 7), filling)], dim=1)
    padded_mask = torch.cat([mask, torch.zeros(5, 3, dtype=torch.bool)], dim=1)
    torch.testing.assert_close(
        network(robot, padded_others, padded_mask), network(*batch), rtol=0, atol=1e-6
    )


def test_each_sample_is_valued_independently_of_its_neighbours(network, batch):
    one_by_one = [network(*(part[i : i + 1] for part in batch)) for i in range(5)]
    torch.testing.assert_close(torch.cat(one_by_one), network(*batch), rtol=0, atol=1e-6)


def test_attention_weights_of_valid_agents_sum_to_one(network, batch):
    torch.testing.assert_close(network.attention_weights(*batch).sum(dim=1), torch.ones(5))


def test_attention_weights_of_invalid_agents_are_exactly_zero(network, batch):
    mask = batch[2]
    assert (network.attention_weights(*batch)[~mask] == 0.0).all()
    assert (network.attention_weights(*batch)[mask] > 0.0).all()


def test_value_depends_on_a_valid_agent_and_on_the_robot(network, batch):
    robot, others, mask = batch
    assert not torch.allclose(network(robot, others + 1.0, mask), network(*batch), atol=1e-4)
    assert not torch.allclose(network(robot + 1.0, others, mask), network(*batch), atol=1e-4)


def test_no_agent_slots_and_only_invalid_agents_have_the_same_value(network, batch):
    robot, others, mask = batch
    without_slots = network(robot, others[:, :0], mask[:, :0])
    without_valid = network(robot, others, torch.zeros_like(mask))
    assert torch.isfinite(without_slots).all()
    torch.testing.assert_close(without_slots, without_valid, rtol=0, atol=1e-6)


def test_no_agent_slots_give_attention_weights_without_entries(network, batch):
    robot, others, mask = batch
    assert network.attention_weights(robot, others[:, :0], mask[:, :0]).shape == (5, 0)


def test_an_empty_batch_has_no_values(network, batch):
    assert network(*(part[:0] for part in batch)).shape == (0,)


@pytest.mark.parametrize('agents', [0, 6])
def test_gradients_are_finite_when_a_sample_has_no_agent(network, batch, agents):
    robot, others, mask = (batch[0], batch[1][:, :agents], batch[2][:, :agents].clone())
    mask[0] = False
    others = others.masked_fill(~mask[:, :, None], float('nan'))
    network(robot, others, mask).sum().backward()
    assert all(torch.isfinite(parameter.grad).all() for parameter in network.parameters())


def test_padding_gets_no_gradient(network, batch):
    robot, others, mask = batch
    others = others.requires_grad_()
    network(robot, others, mask).sum().backward()
    assert (others.grad[~mask] == 0.0).all()
    assert (others.grad[mask] != 0.0).any(dim=1).all()


def test_double_precision_inputs_and_weights_give_double_precision_values(network, batch):
    robot, others, mask = batch
    values = network.double()(robot.double(), others.double(), mask)
    assert values.dtype == torch.float64
