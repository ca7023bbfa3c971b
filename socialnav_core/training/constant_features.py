"""
Features that never vary in training, such as the radius where all are alike.

Nothing is learned of them, and their weights stay what chance made them: harmless as long as the
feature keeps its value, arbitrary where it does not. Folding them into the biases leaves every
value seen in training as it is, and lets the network ignore the feature elsewhere.
"""

import copy

import torch
from torch import nn

from socialnav_core.policies import Gat4snValueNetwork, SarlValueNetwork
from socialnav_core.training.replay_buffer import ReplayBuffer


def without_constant_features(network: nn.Module, buffer: ReplayBuffer) -> nn.Module:
    """
    Return a copy of the network, on the CPU, that ignores what is constant in the buffer.

    :param buffer: states that it was trained on; not empty.
    """
    state = buffer.get_state()
    robot = torch.from_numpy(state['robot'])
    others = torch.from_numpy(state['others'][state['mask']])
    network = copy.deepcopy(network).cpu()
    for layer, robot_column, other_column in input_layers(network):
        if robot_column is not None:
            fold(layer, robot_column, robot)
        if other_column is not None:
            fold(layer, other_column, others)
    return network


def input_layers(network: nn.Module) -> list[tuple[nn.Linear, int | None, int | None]]:
    """Return the layers that read features, and where the robot's and an agent's begin in each."""
    if isinstance(network, SarlValueNetwork):
        return [(network.mlp1[0], 0, 6), (network.value[0], 0, None)]  # type: ignore[list-item]
    assert isinstance(network, Gat4snValueNetwork)
    return [(network.robot_mlp[0], 0, None), (network.other_mlp[0], None, 0)]  # type: ignore


@torch.no_grad()
def fold(layer: nn.Linear, column: int, features: torch.Tensor) -> None:
    """
    Move the weights of constant features into the bias, in place.

    :param column: of the first of them.
    :param features: values they had, (rows, features).
    """
    if not len(features):
        return
    first = features[0]
    for index in torch.nonzero((features == first).all(dim=0)).flatten().tolist():
        layer.bias.add_(first[index] * layer.weight[:, column + index])
        layer.weight[:, column + index] = 0
