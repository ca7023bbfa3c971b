"""SARL: the value network with socially attentive pooling of Chen et al. 2019."""

import torch
from torch import nn

from socialnav_core.policies.value.masked_softmax import masked_softmax
from socialnav_core.policies.value.perceptron import full_precision, Perceptron, rectify


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
        self.mlp1 = Perceptron(13, 150, 100, last_relu=True)
        self.mlp2_hidden = nn.Linear(100, 100)
        self.mlp2_output = nn.Linear(100, 50)
        self.attention_hidden = nn.Linear(200, 100)
        self.attention_output = Perceptron(100, 100, 1)
        self.value = Perceptron(56, 150, 100, 100, 1)

    def forward(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """
        Return the value of each joint state, shape (batch,).

        :param robot: the robot's features, shape (batch, 6).
        :param others: the other agents' features, ignored where invalid, shape (batch, agents, 7).
        :param mask: true where an agent exists, bool, shape (batch, agents).
        """
        embedding = self._embed(robot, others, mask)
        weights = self._attend(embedding, mask)
        hidden = rectify(self.mlp2_hidden(embedding.flatten(0, 1))).view_as(embedding)
        # mlp2 ends in a linear layer and the weights sum to one (or all are zero), so pooling
        # first gives the same sum for one product per sample in place of one per agent.
        pooled = torch.bmm(weights[:, None], hidden).squeeze(1)  # (batch, 100)
        with full_precision(robot):
            crowd = self.mlp2_output(pooled.to(robot.dtype))
            crowd = crowd * mask.any(dim=1, keepdim=True)  # without agents not even the bias
            return self.value(torch.cat([robot, crowd], dim=1)).squeeze(1)

    def attention_weights(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """
        Return how much each agent counts in the crowd's feature, shape (batch, agents).

        Weights of a sample sum to one over its valid agents and are zero elsewhere; inputs are
        those of `forward`.
        """
        return self._attend(self._embed(robot, others, mask), mask)

    def _embed(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """Return e_i of each agent, shape (batch, agents, 100)."""
        robots = robot[:, None].expand(-1, others.shape[1], -1)
        pairs = torch.cat([robots, others], dim=2)
        pairs = pairs.masked_fill_(~mask[:, :, None], 0.0)  # padding may hold anything
        return self.mlp1(pairs.flatten(0, 1)).view(*mask.shape, 100)

    def _attend(self, embedding: torch.Tensor, mask: torch.Tensor) -> torch.Tensor:
        """Return w_i of each agent, shape (batch, agents)."""
        shares = mask.to(embedding.dtype)
        shares = shares / shares.sum(dim=1, keepdim=True).clamp(min=1)
        mean = torch.bmm(shares[:, None], embedding).squeeze(1)
        # The mean is the same for all agents of a sample: its part of the score is computed once.
        own_part, mean_part = self.attention_hidden.weight.t().split(100)
        from_mean = torch.addmm(self.attention_hidden.bias, mean, mean_part)[:, None]
        from_own = torch.mm(embedding.flatten(0, 1), own_part).view_as(embedding)
        hidden = rectify(from_own + from_mean).flatten(0, 1)
        return masked_softmax(self.attention_output(hidden).view(mask.shape), mask)
