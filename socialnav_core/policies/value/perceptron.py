"""Perceptrons on rows: what `nn.Sequential` computes, without the overhead of its modules."""

from contextlib import AbstractContextManager, nullcontext

import torch
from torch import nn
from torch.nn import functional


class Perceptron(nn.Sequential):
    """
    Linear layers from each size to the next with ReLU between them: (rows, first) to (rows, last).

    It computes what `nn.Sequential` would, with less overhead: a batch may be one decision.
    """

    def __init__(self, *sizes: int, last_relu: bool = False) -> None:
        """Create the layers, initialised as PyTorch does; the last has a ReLU where asked for."""
        layers = [nn.Linear(*pair) for pair in zip(sizes[:-1], sizes[1:], strict=True)]
        modules = [module for layer in layers for module in (layer, nn.ReLU())]
        super().__init__(*(modules if last_relu else modules[:-1]))
        self._layers = [(layer.weight, layer.bias) for layer in layers]
        self._rectified = len(layers) if last_relu else len(layers) - 1

    def forward(self, rows: torch.Tensor) -> torch.Tensor:
        """Return the rows after all layers."""
        for number, (weight, bias) in enumerate(self._layers):
            rows = functional.linear(rows, weight, bias)
            if number < self._rectified:
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
