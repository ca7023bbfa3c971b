"""Laws of perceptrons."""

import copy

import pytest
import torch
from torch import nn

from socialnav_core.policies.value.perceptron import full_precision, Perceptron, rectify


@pytest.mark.parametrize('last_relu', [False, True])
def test_rows_come_out_as_the_modules_return_them(last_relu):
    torch.manual_seed(0)
    modules, rows = Perceptron(3, 5, 1, last_relu=last_relu), torch.randn(4, 3)
    torch.testing.assert_close(modules(rows), nn.Sequential(*modules)(rows))


def test_a_relu_follows_every_layer_but_the_last_unless_it_is_asked_for():
    kinds = [type(module) for module in Perceptron(3, 5, 1)]
    assert kinds == [nn.Linear, nn.ReLU, nn.Linear]
    assert [type(module) for module in Perceptron(3, 5, 1, last_relu=True)] == [*kinds, nn.ReLU]


def test_a_perceptron_follows_its_weights_wherever_they_go():
    torch.manual_seed(0)
    modules, rows = Perceptron(3, 5, 1), torch.randn(4, 3)
    other = copy.deepcopy(modules)
    with torch.no_grad():
        other[0].weight.mul_(2.0)
    assert not torch.allclose(other(rows), modules(rows))
    modules.load_state_dict(other.state_dict())
    torch.testing.assert_close(modules(rows), other(rows))
    torch.testing.assert_close(modules.double()(rows.double()).float(), other(rows))


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
