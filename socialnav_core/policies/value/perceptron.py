"""Perceptrons on rows: what `nn.Sequential` computes, without the overhead of its modules."""

from contextlib import AbstractContextManager, nullcontext

import torch
from torch import nn
from torch.nn import functional


def perceptron(*sizes: int, last_relu: bool = False) -> nn.Sequential:
    """Return linear layers from each size to the next with ReLU between them, or after all."""
    layers: list[nn.Module] = []
    for inputs, outputs in zip(sizes[:-1], sizes[1:], strict=True):
        layers += [nn.Linear(inputs, outputs), nn.ReLU()]
    return nn.Sequential(*(layers if last_relu else layers[:-1]))


def linear(rows: torch.Tensor, layer: nn.Linear) -> torch.Tensor:
    """Return the rows after a linear layer, (rows, inputs) to (rows, outputs)."""
    return functional.linear(rows, layer.weight, layer.bias)


def apply(rows: torch.Tensor, layers: nn.Sequential) -> torch.Tensor:
    """
    Return the rows after linear layers and ReLUs, (rows, inputs) to (rows, outputs).

    `nn.Sequential` gives the same more slowly where batches are as small as one decision's.
    """
    for layer in layers:
        if type(layer) is nn.Linear:
            rows = functional.linear(rows, layer.weight, layer.bias)
        else:
            rows = rectify(rows)
    return rows


def rectify(rows: torch.Tensor) -> torch.Tensor:
    """Return the rows after ReLU, computed in place; without gradients no NaN may be in them."""
    if rows.dtype != torch.bfloat16 or torch.is_grad_enabled():
        return torch.relu_(rows)
    # The sign of a number is that of the integer with the same bits, five times as fast.
    rows.view(torch.int16).clamp_(min=0)
    return rows


def full_precision(tensor: torch.Tensor) -> AbstractContextManager[None]:
    """Return a context without autocast: a value in bfloat16 has fewer than three digits."""
    device = tensor.device.type
    if not torch.is_autocast_enabled(device):
        return nullcontext()
    return torch.autocast(device, enabled=False)
