"""GAT4SN: the value network with graph attention of the project's report."""

import torch
from torch import nn
from torch.nn import functional

from socialnav_core.policies.value.graph_attention import GraphAttention
from socialnav_core.policies.value.perceptron import full_precision, Perceptron


class Gat4snValueNetwork(nn.Module):
    r"""
    Estimate the value of a joint state of the robot and any number of other agents.

    With s the robot's features and o_i those of agent i (section IV of the project's report)::

        h_r   = robot_mlp(s)                                          6-100-50
        h_i   = other_mlp(o_i)                                        7-100-50
        H^K   = ELU(att_1(h)) || ... || ELU(att_K(h))                 equation 3, rows of 50 K
        H^out = ELU(att_out(H^K))                                     rows of 75
        h^G   = [h^out_r || sum_i h^out_i]                            equation 4
        V     = value(h^G)                                            150-150-100-100-1

    ReLU follows both layers of robot_mlp and other_mlp and all but the last of value. The
    attention (equations 1 and 2) and its scores are those of `GraphAttention`. Sum and softmax run
    over the valid agents alone; without any the sum is zero. 59,701 + 6,350 heads parameters.
    """

    def __init__(self, heads: int = 4, score: str = 'gat') -> None:
        """
        Create the perceptrons with PyTorch's default initialisation, the attention with Xavier's.

        :param heads: number of hidden attention heads K.
        :param score: attention score of both layers, see `GraphAttention`.
        """
        super().__init__()
        self.robot_mlp = Perceptron(6, 100, 50, last_relu=True)
        self.other_mlp = Perceptron(7, 100, 50, last_relu=True)
        self.hidden_attention = GraphAttention(50, 50, heads, score)
        self.output_attention = GraphAttention(50 * heads, 75, 1, score)
        self.value = Perceptron(150, 150, 100, 100, 1)

    def forward(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """
        Return the value of each joint state, shape (batch,).

        :param robot: the robot's features, shape (batch, 6).
        :param others: the other agents' features, ignored where invalid, shape (batch, agents, 7).
        :param mask: true where an agent exists, bool, shape (batch, agents).
        """
        robot_row, other_rows, _ = self._attend(robot, others, mask)
        # Rows of invalid agents are zero, and ELU keeps them so.
        crowd = functional.elu_(other_rows).sum(dim=1)
        graph = torch.cat([functional.elu_(robot_row), crowd], dim=1).to(robot.dtype)
        with full_precision(robot):
            return self.value(graph).squeeze(1)

    def attention_weights(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> torch.Tensor:
        """
        Return the output head's weight of each agent, shape (batch, agents).

        Weights of a sample sum to one over its valid agents and are zero elsewhere. The hidden
        heads have weights of their own, which act before these. Inputs are those of `forward`.
        """
        return self._attend(robot, others, mask)[2].squeeze(1)

    def _attend(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """Return what the output attention returns: robot's row, agents' rows and weights."""
        valid_others = others.masked_fill(~mask[:, :, None], 0.0)  # padding may hold anything
        robot_row = self.robot_mlp(robot)  # once per sample, not once per pair
        other_rows = self.other_mlp(valid_others.flatten(0, 1)).view(*mask.shape, 50)
        robot_row, other_rows, _ = self.hidden_attention(robot_row, other_rows, mask)
        robot_row, other_rows = functional.elu_(robot_row), functional.elu_(other_rows)
        return self.output_attention(robot_row, other_rows, mask)
