"""Laws of perceptrons."""

import pytest
import torch
from torch import nn

from socialnav_core.policies.value.perceptron import apply, full_precision, perceptron, rectify


@pytest.mark.parametrize('last_relu', [False, True])
def test_rows_come_out_as_the_modules_return_them(last_relu):
    torch.manual_seed(0)
    modules, rows = perceptron(3, 5, 1, last_relu=last_relu), torch.randn(4, 3)
    torch.testing.assert_close(apply(rows, modules), modules(rows))


def test_a_relu_follows_every_layer_but_the_last_unless_it_is_asked_for():
    kinds = [type(module) for module in perceptron(3, 5, 1)]
    assert kinds == [nn.Linear, nn.ReLU, nn.Linear]
    assert [type(module) for module in perceptron(3, 5, 1, last_relu=True)] == [*kinds, nn.ReLU]


def test_every_bfloat16_is_rectified_alike_with_and_without_gradients():
    numbers = torch.arange(-(2**15), 2**15).to(torch.int16).view(torch.bfloat16)
    numbers = numbers[~numbers.isnan()]
    with torch.no_grad():
        assert torch.equal(rectify(numbers.clone()), torch.relu(numbers))
    with torch.enable_grad():
        assert torch.equal(rectify(numbers.clone()), torch.relu(numbers))


def test_products_are_in_float32_within_autocast_where_full_precision_is_asked_for():
    rows, weight = torch.randn(4, 3), torch.randn(3, 5)
    with torch.autocast('cpu', torch.bfloat16):
        assert torch.mm(rows, weight).dtype == torch.bfloat16
        with full_precision(rows):
            assert torch.mm(rows, weight).dtype == torch.float32
