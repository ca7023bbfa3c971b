"""The SARL network against its equations."""

import torch
from torch.nn import functional

from socialnav_core.policies.value.sarl import SarlValueNetwork

MLP1 = ('mlp1.0', 'mlp1.2')
MLP2 = ('mlp2_hidden', 'mlp2_output')
ATTENTION = ('attention_hidden', 'attention_output.0', 'attention_output.2')
VALUE = ('value.0', 'value.2', 'value.4', 'value.6')


def _layers(
    network: SarlValueNetwork, names: tuple[str, ...], row: torch.Tensor, last: bool = False
) -> torch.Tensor:
    """Apply the named linear layers to one row, with ReLU after the last one or without."""
    for name in names:
        layer = network.get_submodule(name)
        row = layer.weight @ row + layer.bias
        if last or name != names[-1]:
            row = functional.relu(row)
    return row


def _literal_value(
    network: SarlValueNetwork, robot: torch.Tensor, agents: list[torch.Tensor]
) -> tuple[torch.Tensor, torch.Tensor]:
    """Return value and weights of one sample, agent by agent as the equations are printed."""
    embeddings = [_layers(network, MLP1, torch.cat([robot, agent]), True) for agent in agents]
    mean = sum(embeddings) / len(embeddings)
    features = [_layers(network, MLP2, embedding) for embedding in embeddings]
    scores = [_layers(network, ATTENTION, torch.cat([e, mean])) for e in embeddings]
    weights = torch.cat(scores).exp() / torch.cat(scores).exp().sum()
    crowd = sum(weight * feature for weight, feature in zip(weights, features, strict=True))
    return _layers(network, VALUE, torch.cat([robot, crowd])), weights


def test_sarl_has_96502_parameters():
    assert sum(parameter.numel() for parameter in SarlValueNetwork().parameters()) == 96_502


def test_forward_equals_the_equations_read_literally():
    torch.manual_seed(0)
    network = SarlValueNetwork()
    robot, others = torch.randn(4, 6), 3.0 * torch.randn(4, 5, 7)
    mask = torch.tensor([[1, 1, 1, 1, 1], [0, 1, 1, 0, 1], [1, 0, 0, 0, 0], [1, 1, 0, 1, 1]]) > 0
    values, weights = network(robot, others, mask), network.attention_weights(robot, others, mask)
    for sample in range(4):
        agents = list(others[sample, mask[sample]])
        value, literal_weights = _literal_value(network, robot[sample], agents)
        torch.testing.assert_close(values[sample], value[0], rtol=0, atol=1e-5)
        torch.testing.assert_close(
            weights[sample, mask[sample]], literal_weights, rtol=0, atol=1e-5
        )


def test_value_without_agents_is_that_of_a_zero_crowd_feature():
    torch.manual_seed(0)
    network = SarlValueNetwork()
    robot = torch.randn(1, 6)
    value = network(robot, torch.zeros(1, 0, 7), torch.zeros(1, 0, dtype=torch.bool))
    expected = _layers(network, VALUE, torch.cat([robot[0], torch.zeros(50)]))
    torch.testing.assert_close(value, expected, rtol=0, atol=1e-6)
