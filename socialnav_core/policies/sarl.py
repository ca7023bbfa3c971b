"""SARL: the value network with socially attentive pooling of Chen et al. 2019."""

import torch
from torch import nn
from torch.nn import functional

from socialnav_core.policies.masked_softmax import masked_softmax


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
        hidden, weights = self._attend(robot, others, mask)
        # mlp2 ends in a linear layer and the weights sum to one (or all are zero), so pooling
        # first gives the same sum for one product per sample in place of one per agent.
        pooled = torch.bmm(weights[:, None], hidden).squeeze(1)  # (batch, 100)
        occupied = mask.any(dim=1, keepdim=True)
        crowd = functional.linear(pooled, self.mlp2_output.weight)
        crowd = crowd + occupied * self.mlp2_output.bias
        return self.value(torch.cat([robot, crowd], dim=1)).squeeze(1)

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
        return self._attend(robot, others, mask)[1]

    def _attend(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> tuple[torch.Tensor, torch.Tensor]:
        """Return mlp2's hidden layer (batch, agents, 100) and the weights (batch, agents)."""
        embedding = self._embed(robot, others, mask)
        share = mask.to(robot.dtype) / mask.sum(dim=1, keepdim=True).clamp(min=1)
        mean = torch.bmm(share[:, None], embedding).squeeze(1)  # (batch, 100)
        # mlp2 and the score read the same embedding: their first layers are one product. The
        # mean is the same for all agents of a sample, so its part of the score is added after.
        own_part, mean_part = self.attention_hidden.weight.split(100, dim=1)
        both = functional.linear(embedding, torch.cat([self.mlp2_hidden.weight, own_part]))
        hidden, score_hidden = both.split(100, dim=2)
        hidden = functional.relu(hidden + self.mlp2_hidden.bias)
        from_mean = functional.linear(mean, mean_part, self.attention_hidden.bias)
        score_hidden = functional.relu(score_hidden + from_mean[:, None])
        scores = self.attention_output(score_hidden).squeeze(2)
        return hidden, masked_softmax(scores, mask)

    def _embed(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """Return mlp1 of each pair of robot and agent, shape (batch, agents, 100)."""
        valid_others = others.masked_fill(~mask[:, :, None], 0.0)  # padding may hold anything
        robots = robot[:, None].expand(-1, others.shape[1], -1)
        return self.mlp1(torch.cat([robots, valid_others], dim=2))
