"""The GAT4SN network against the equations of the project's report."""

import pytest
import torch
from torch.nn import functional

from socialnav_core.policies.value.gat4sn import Gat4snValueNetwork


def _layers(network: Gat4snValueNetwork, name: str, row: torch.Tensor, last: bool) -> torch.Tensor:
    """Apply the named perceptron's layers to one row, with ReLU after the last one or without."""
    state = network.state_dict()
    indices = sorted({int(key.split('.')[1]) for key in state if key.startswith(f'{name}.')})
    for index in indices:
        row = state[f'{name}.{index}.weight'] @ row + state[f'{name}.{index}.bias']
        if last or index != indices[-1]:
            row = functional.relu(row)
    return row


def _literal_attention(
    weight: torch.Tensor, attention: torch.Tensor, rows: list[torch.Tensor]
) -> tuple[list[torch.Tensor], torch.Tensor]:
    """Return H and alpha of equations 1 and 2; the robot's row comes first."""
    robot, *agents = [weight @ row for row in rows]
    scores = torch.stack([attention @ torch.cat([robot, agent]) for agent in agents])
    scores = torch.where(scores > 0, scores, 0.2 * scores).exp()
    alpha = scores / scores.sum()
    return [robot] + [a * agent for a, agent in zip(alpha, agents, strict=True)], alpha


def _literal_value(
    network: Gat4snValueNetwork, robot: torch.Tensor, agents: list[torch.Tensor]
) -> tuple[torch.Tensor, torch.Tensor]:
    """Return value and output weights of one sample, row by row as the equations are printed."""
    hidden, output = network.hidden_attention, network.output_attention
    rows = [_layers(network, 'robot_mlp', robot, True)]
    rows += [_layers(network, 'other_mlp', agent, True) for agent in agents]
    heads = [
        _literal_attention(weight, attention, rows)[0]
        for weight, attention in zip(hidden.weight, hidden.attention, strict=True)
    ]
    rows = [functional.elu(torch.cat(parts)) for parts in zip(*heads, strict=True)]  # equation 3
    rows, alpha = _literal_attention(output.weight[0], output.attention[0], rows)
    robot_row, *agent_rows = [functional.elu(row) for row in rows]
    graph = torch.cat([robot_row, sum(agent_rows)])  # equation 4
    return _layers(network, 'value', graph, False), alpha


@pytest.mark.parametrize(
    ('heads', 'parameters'), [(1, 66_051), (2, 72_401), (3, 78_751), (4, 85_101)]
)
def test_gat4sn_has_the_parameter_counts_of_table_2_of_the_report(heads, parameters):
    network = Gat4snValueNetwork(heads=heads)
    assert sum(parameter.numel() for parameter in network.parameters()) == parameters


@pytest.mark.parametrize('heads', [1, 2, 3, 4])
def test_forward_equals_the_equations_read_literally(heads):
    torch.manual_seed(heads)
    network = Gat4snValueNetwork(heads)
    robot, others = torch.randn(4, 6), 3.0 * torch.randn(4, 5, 7)
    mask = torch.tensor([[1, 1, 1, 1, 1], [0, 1, 1, 0, 1], [1, 0, 0, 0, 0], [1, 1, 0, 1, 1]]) > 0
    values, weights = network(robot, others, mask), network.attention_weights(robot, others, mask)
    for sample in range(4):
        agents = list(others[sample, mask[sample]])
        value, alpha = _literal_value(network, robot[sample], agents)
        torch.testing.assert_close(values[sample], value[0], rtol=0, atol=1e-5)
        torch.testing.assert_close(weights[sample, mask[sample]], alpha, rtol=0, atol=1e-5)
