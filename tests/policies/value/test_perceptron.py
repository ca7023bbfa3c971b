"""Laws of perceptrons on plain tensors."""

import torch
from torch import nn

from socialnav_core.policies.value.perceptron import (
    full_precision,
    linear_layers,
    rectified,
    rectify,
    scalar,
)


def _modules() -> nn.Sequential:
    torch.manual_seed(0)
    return nn.Sequential(nn.Linear(3, 5), nn.ReLU(), nn.Linear(5, 1))


def test_scalar_is_what_the_modules_return():
    modules, rows = _modules(), torch.randn(4, 3)
    torch.testing.assert_close(scalar(rows, linear_layers(modules)), modules(rows)[:, 0])


def test_rectified_has_a_relu_after_the_last_layer_too():
    modules, rows = _modules(), torch.randn(4, 3)
    expected = torch.relu(modules(rows))
    torch.testing.assert_close(rectified(rows, linear_layers(modules)), expected)


def test_every_bfloat16_is_rectified_alike_with_and_without_gradients():
    numbers = torch.arange(-(2**15), 2**15).to(torch.int16).view(torch.bfloat16)
    numbers = numbers[~numbers.isnan()]
    with torch.no_grad():
        assert torch.equal(rectify(numbers.clone()), torch.relu(numbers))
    with torch.enable_grad():
        assert torch.equal(rectify(numbers.clone()), torch.relu(numbers))


def test_layers_show_a_change_of_the_weights_made_in_place():
    modules, rows = _modules(), torch.randn(4, 3)
    layers = linear_layers(modules)
    with torch.no_grad():
        modules[0].weight.mul_(2.0)
    torch.testing.assert_close(scalar(rows, layers), modules(rows)[:, 0])


def test_products_are_in_float32_within_autocast_where_full_precision_is_asked_for():
    rows, weight = torch.randn(4, 3), torch.randn(3, 5)
    with torch.autocast('cpu', torch.bfloat16):
        assert torch.mm(rows, weight).dtype == torch.bfloat16
        with full_precision(rows):
            assert torch.mm(rows, weight).dtype == torch.float32
