"""Laws of the optimizers."""

import dataclasses

import pytest
import torch

from socialnav_core.config import ConfigError, TrainingConfig
from socialnav_core.training.optimizers import make_optimizer
from socialnav_core.training.resume import optimizer_arrays, restore_optimizer


def descend(network, optimizer, steps=3):
    """Take steps along constant gradients of one."""
    for _ in range(steps):
        for parameter in network.parameters():
            parameter.grad = torch.ones_like(parameter)
        optimizer.step()


def test_sgd_adds_momentum():
    network = torch.nn.Linear(1, 1, bias=False)
    start = network.weight.item()
    config = TrainingConfig(optimizer='sgd', learning_rate=0.01, momentum=0.5)
    descend(network, make_optimizer(network, config))
    assert start - network.weight.item() == pytest.approx(0.01 * (1 + 1.5 + 1.75), rel=1e-4)


@pytest.mark.parametrize('settings', [
    {'optimizer': 'adam'}, {'optimizer': 'sgd'}, {'optimizer': 'sgd', 'momentum': 0.0},
])  # fmt: skip
def test_stored_optimizer_goes_on_like_the_original(settings):
    config = dataclasses.replace(TrainingConfig(), **settings)
    original, copy = torch.nn.Linear(2, 2), torch.nn.Linear(2, 2)
    first, second = make_optimizer(original, config), make_optimizer(copy, config)
    descend(original, first)
    copy.load_state_dict(original.state_dict())
    stored = {name: array.copy() for name, array in optimizer_arrays(first).items()}
    restore_optimizer(second, stored)
    descend(original, first)
    descend(copy, second)
    torch.testing.assert_close(copy.weight, original.weight, rtol=0, atol=0)


@pytest.mark.parametrize('settings', [
    {'optimizer': 'rmsprop'}, {'momentum': 1.0}, {'episodes': -1}, {'updates_per_episode': -1},
    {'target_update_episodes': 50, 'trace_decay': 0.7},
])  # fmt: skip
def test_settings_that_make_no_sense_are_refused(settings):
    with pytest.raises(ConfigError, match=next(iter(settings))):
        TrainingConfig(**settings)
