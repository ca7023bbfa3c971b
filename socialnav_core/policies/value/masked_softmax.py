"""Softmax over the agents that exist."""

import torch


def masked_softmax(scores: torch.Tensor, mask: torch.Tensor) -> torch.Tensor:
    """
    Return softmax weights over the last axis that are exactly zero where the mask is false.

    Where nothing is valid all weights are zero; neither values nor gradients are ever NaN.

    :param scores: shape (..., agents).
    :param mask: true where an agent exists, broadcastable to the shape of scores.
    :returns: weights, shape (..., agents).
    """
    invalid = ~mask
    # A finite fill, since a row of -inf alone would come out of the softmax as NaN.
    filled = scores.masked_fill(invalid, torch.finfo(scores.dtype).min)
    return torch.softmax(filled, dim=-1).masked_fill(invalid, 0.0)
