"""Perceptrons on plain tensors, which take a third less time than modules on small batches."""

from collections.abc import Iterable
from contextlib import AbstractContextManager, nullcontext

import torch
from torch import nn

Layer = tuple[torch.Tensor, torch.Tensor]
"""A linear layer: its weight transposed, (inputs, outputs), and its bias, (outputs,)."""


def linear_layer(module: nn.Linear) -> Layer:
    """
    Return the layer's tensors as views, which show later changes made in place.

    :param module: a linear layer with a bias.
    """
    return module.weight.t(), module.bias


def linear_layers(modules: nn.Sequential) -> list[Layer]:
    """
    Return the tensors of all linear layers among the modules, in order.

    :param modules: linear layers, between them whatever has no parameters.
    """
    return [linear_layer(module) for module in modules if isinstance(module, nn.Linear)]


def rectified(rows: torch.Tensor, layers: Iterable[Layer]) -> torch.Tensor:
    """
    Return the rows after each layer in turn, with ReLU after every one, shape (rows, outputs).

    :param rows: shape (rows, inputs).
    :param layers: see `Layer`.
    """
    for weight, bias in layers:
        rows = rectify(torch.addmm(bias, rows, weight))
    return rows


def rectify(rows: torch.Tensor) -> torch.Tensor:
    """
    Return the rows after ReLU, computed in place.

    :param rows: any shape; without gradients no NaN.
    """
    if rows.dtype != torch.bfloat16 or torch.is_grad_enabled():
        return torch.relu_(rows)
    # The sign of a number is that of the integer with the same bits, five times as fast.
    rows.view(torch.int16).clamp_(min=0)
    return rows


def scalar(rows: torch.Tensor, layers: list[Layer]) -> torch.Tensor:
    """
    Return the one output of a perceptron without ReLU after its last layer, shape (rows,).

    :param rows: shape (rows, inputs).
    :param layers: see `Layer`; the last one has one output.
    """
    weight, bias = layers[-1]
    return torch.addmm(bias, rectified(rows, layers[:-1]), weight).squeeze(1)


def full_precision(tensor: torch.Tensor) -> AbstractContextManager[None]:
    """
    Return a context in which autocast is off: a value in bfloat16 has fewer than three digits.

    :param tensor: any tensor of the device in question.
    """
    device = tensor.device.type
    if not torch.is_autocast_enabled(device):
        return nullcontext()
    return torch.autocast(device, enabled=False)
