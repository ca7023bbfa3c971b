"""SARL: the value network with socially attentive pooling of Chen et al. 2019."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import torch
from torch import nn

from socialnav_core.policies.value.masked_softmax import masked_softmax
from socialnav_core.policies.value.perceptron import (
    full_precision,
    Layer,
    linear_layer,
    linear_layers,
    rectified,
    rectify,
    scalar,
)


class SarlValueNetwork(nn.Module):
    r"""
    Estimate the value of a joint state of the robot and any number of other agents.

    With s the robot's features and o_i those of agent i (equations 3 to 6 of Chen et al. 2019,
    "Crowd-Robot Interaction", without the local map)::

        e_i     = mlp1([s || o_i])                                    13-150-100
        f_i     = mlp2(e_i)                                           100-100-50
        w       = softmax_i(attention([e_i || mean_j e_j]))           200-100-100-1
        V       = value([s || sum_i w_i f_i])                         56-150-100-100-1

    ReLU follows every linear layer but the last ones of mlp2, attention and value. Sums, mean
    and softmax run over the valid agents alone; without any the crowd's feature is zero. The
    layers of mlp2 and attention have names of their own, since the products are regrouped.
    96,502 parameters.
    """

    def __init__(self) -> None:
        """Create the four perceptrons with PyTorch's default initialisation."""
        super().__init__()
        self.mlp1 = nn.Sequential(nn.Linear(13, 150), nn.ReLU(), nn.Linear(150, 100), nn.ReLU())
        self.mlp2_hidden = nn.Linear(100, 100)
        self.mlp2_output = nn.Linear(100, 50)
        self.attention_hidden = nn.Linear(200, 100)
        self.attention_output = nn.Sequential(nn.Linear(100, 100), nn.ReLU(), nn.Linear(100, 1))
        self.value = nn.Sequential(
            nn.Linear(56, 150),
            nn.ReLU(),
            nn.Linear(150, 100),
            nn.ReLU(),
            nn.Linear(100, 100),
            nn.ReLU(),
            nn.Linear(100, 1),
        )

    def forward(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """
        Return the value of each joint state, shape (batch,).

        :param robot: the robot's features, shape (batch, 6).
        :param others: the other agents' features, ignored where invalid, shape (batch, agents, 7).
        :param mask: true where an agent exists, bool, shape (batch, agents).
        """
        return _value(self._tensors(), robot, others, mask)

    def attention_weights(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """
        Return how much each agent counts in the crowd's feature, shape (batch, agents).

        Weights of a sample sum to one over its valid agents and are zero elsewhere.

        :param robot: the robot's features, shape (batch, 6).
        :param others: the other agents' features, shape (batch, agents, 7).
        :param mask: true where an agent exists, bool, shape (batch, agents).
        """
        return _attend(self._tensors(), robot, others, mask)[1]

    def prepared(self) -> Callable[..., torch.Tensor]:
        """Return `forward` with the parameters looked up; it sees changes made in place."""
        return partial(_value, self._tensors())

    def _tensors(self) -> '_Tensors':
        """Return views of all parameters."""
        own_part, mean_part = self.attention_hidden.weight.t().split(100)
        return _Tensors(
            mlp1=linear_layers(self.mlp1),
            mlp2_hidden=linear_layer(self.mlp2_hidden),
            mlp2_output=linear_layer(self.mlp2_output),
            score_own=own_part,
            score_mean=(mean_part, self.attention_hidden.bias),
            score_output=linear_layers(self.attention_output),
            value=linear_layers(self.value),
        )


class _Tensors(NamedTuple):
    """The parameters as the equations use them."""

    mlp1: list[Layer]
    mlp2_hidden: Layer
    mlp2_output: Layer
    score_own: torch.Tensor
    """Part of the first attention layer that reads e_i, (100, 100)."""
    score_mean: Layer
    """Part of it that reads the mean."""
    score_output: list[Layer]
    value: list[Layer]


def _value(
    tensors: _Tensors, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
) -> torch.Tensor:
    """Return the value of each sample, shape (batch,)."""
    hidden, weights = _attend(tensors, robot, others, mask)
    # mlp2 ends in a linear layer and the weights sum to one (or all are zero), so pooling
    # first gives the same sum for one product per sample in place of one per agent.
    pooled = torch.bmm(weights[:, None], hidden).squeeze(1)  # (batch, 100)
    weight, bias = tensors.mlp2_output
    with full_precision(robot):
        crowd = torch.addmm(bias, pooled.to(robot.dtype), weight)
        crowd = crowd * mask.any(dim=1, keepdim=True)  # without agents not even the bias
        return scalar(torch.cat([robot, crowd], dim=1), tensors.value)


def _attend(
    tensors: _Tensors, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
) -> tuple[torch.Tensor, torch.Tensor]:
    """Return mlp2's hidden layer (batch, agents, 100) and the weights (batch, agents)."""
    batch, agents = mask.shape
    embedding = rectified(_pairs(robot, others, mask), tensors.mlp1)  # (batch * agents, 100)
    shares = mask.to(robot.dtype)
    shares = shares / shares.sum(dim=1, keepdim=True).clamp(min=1)
    mean = torch.bmm(shares[:, None], embedding.view(batch, agents, 100)).squeeze(1)
    # The mean is the same for all agents of a sample: its part of the score is computed once.
    weight, bias = tensors.score_mean
    from_mean = torch.addmm(bias, mean, weight)[:, None]
    score_hidden = torch.mm(embedding, tensors.score_own).view(batch, agents, 100)
    score_hidden = rectify(score_hidden + from_mean).view(batch * agents, 100)
    scores = scalar(score_hidden, tensors.score_output).view(batch, agents)
    hidden = rectified(embedding, [tensors.mlp2_hidden])
    return hidden.view(batch, agents, 100), masked_softmax(scores, mask)


def _pairs(robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor) -> torch.Tensor:
    """Return the features of each pair of robot and agent, shape (batch * agents, 13)."""
    robots = robot[:, None].expand(-1, others.shape[1], -1)
    pairs = torch.cat([robots, others], dim=2)
    return pairs.masked_fill_(~mask[:, :, None], 0.0).flatten(0, 1)  # padding may hold anything
