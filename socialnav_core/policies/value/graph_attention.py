"""The masked dense graph-attention layer between the robot and the agents around it."""

import torch
from torch import nn
from torch.nn import functional

from socialnav_core.policies.value.masked_softmax import masked_softmax

NEGATIVE_SLOPE = 0.2
XAVIER_GAIN = 1.414


class GraphAttention(nn.Module):
    r"""
    Let the robot's node attend to the nodes of the other agents, with several heads at once.

    The operator of Velickovic et al. 2018, "Graph Attention Networks", on a star whose centre
    is the robot r, as equations 1 and 2 of the project's report have it. For every head::

        h'_r = W h_r
        h'_i = alpha_i W h_i
        alpha_i = softmax_i(LeakyReLU_0.2(a^T [W h_r || W h_i]))

    The softmax runs over the valid agents alone, not over the robot itself. There is no bias
    and no activation after the layer; the heads are concatenated.

    Three scores can be chosen; all have the same softmax:

    - ``'gat'``: as above. The order of the agents by weight does not depend on the robot, for
      LeakyReLU grows with the agent's own part ("static" attention, Brody et al. 2022).
    - ``'linear'``: without the LeakyReLU. The robot's part cancels in the softmax.
    - ``'gatv2'``: a^T LeakyReLU_0.2(W h_r + W h_i), whose order can depend on the robot (Brody
      et al. 2022, "How Attentive are Graph Attention Networks?", with shared weights).

    Its parameters are

    - ``weight``, W of all heads, shape (heads, output_size, input_size)
    - ``attention``, a of all heads, shape (heads, 2 * output_size), for ``'gatv2'``
      (heads, output_size)

    Its shapes are

    - in: robot (batch, input_size), others (batch, agents, input_size), mask (batch, agents)
    - out: robot (batch, heads * output_size), others (batch, agents, heads * output_size),
      attention weights (batch, heads, agents)
    """

    def __init__(
        self, input_size: int, output_size: int, heads: int = 1, score: str = 'gat'
    ) -> None:
        """
        Create the layer with Xavier-uniform parameters.

        :param output_size: length of an output row of one head.
        :param score: 'gat', 'linear' or 'gatv2'.
        :raises ValueError: when heads or score is none of these.
        """
        super().__init__()
        if heads < 1:
            raise ValueError(f'heads must be at least 1, got {heads}')
        if score not in ('gat', 'linear', 'gatv2'):
            raise ValueError(f"score must be 'gat', 'linear' or 'gatv2', got {score!r}")
        self.score = score
        attention_size = output_size if score == 'gatv2' else 2 * output_size
        self.weight = nn.Parameter(torch.empty(heads, output_size, input_size))
        self.attention = nn.Parameter(torch.empty(heads, attention_size))
        for head in range(heads):
            nn.init.xavier_uniform_(self.weight.data[head], XAVIER_GAIN)
            nn.init.xavier_uniform_(self.attention.data[head, :, None], XAVIER_GAIN)

    def forward(
        self, robot: torch.Tensor, others: torch.Tensor, mask: torch.Tensor
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """
        Return the robot's new row, the agents' new rows and the attention weights.

        Rows and weights of invalid agents are zero, provided that what came in is finite.

        :param robot: shape (batch, input_size).
        :param others: shape (batch, agents, input_size).
        :param mask: true where an agent exists, bool, shape (batch, agents).
        :returns: the three tensors described above.
        """
        weight = self.weight
        heads, output_size, _ = weight.shape
        projection = weight.flatten(0, 1).t()  # all heads are one product
        robot_rows = torch.mm(robot, projection)
        other_rows = torch.mm(others.flatten(0, 1), projection)
        other_rows = other_rows.view(*mask.shape, heads, output_size)
        if self.score == 'gatv2':
            scores = _dynamic_scores(self.attention, robot_rows, other_rows)
        else:
            scores = _static_scores(weight, self.attention, robot, others)
            if self.score == 'gat':
                scores = functional.leaky_relu_(scores, NEGATIVE_SLOPE)
        weights = masked_softmax(scores.transpose(1, 2), mask[:, None])
        weighted = _weighted(other_rows, weights.transpose(1, 2)[..., None])
        return robot_rows, weighted.flatten(2), weights


def _weighted(rows: torch.Tensor, weights: torch.Tensor) -> torch.Tensor:
    """Return rows times weights, in place where nobody needs the rows any more."""
    if torch.is_grad_enabled() or rows.dtype != weights.dtype:
        return rows * weights
    return rows.mul_(weights)  # fresh memory would take longer than the product itself


def _static_scores(
    weight: torch.Tensor, attention: torch.Tensor, robot: torch.Tensor, others: torch.Tensor
) -> torch.Tensor:
    """Return a^T [W h_r || W h_i], shape (batch, agents, heads)."""
    heads, output_size, _ = weight.shape
    # a^T (W h) is computed as (W^T a)^T h: one number per head in place of a whole row.
    halves = attention.view(heads, 2, output_size)
    robot_vector, other_vector = torch.bmm(halves, weight).unbind(1)  # (heads, input)
    other_part = torch.mm(others.flatten(0, 1), other_vector.t()).view(*others.shape[:2], heads)
    return other_part + torch.mm(robot, robot_vector.t())[:, None]


def _dynamic_scores(
    attention: torch.Tensor, robot_rows: torch.Tensor, other_rows: torch.Tensor
) -> torch.Tensor:
    """Return a^T LeakyReLU(W h_r + W h_i), shape (batch, agents, heads)."""
    robots = robot_rows.unflatten(1, other_rows.shape[2:])[:, None]
    mixed = functional.leaky_relu_(robots + other_rows, NEGATIVE_SLOPE)
    return (mixed * attention).sum(dim=3)
