"""How gradients become steps."""

import torch
from torch import nn

from socialnav_core.config import TrainingConfig


def make_optimizer(network: nn.Module, config: TrainingConfig) -> torch.optim.Optimizer:
    """Return the optimizer of a network's parameters; each step is given its learning rate."""
    if config.optimizer == 'sgd':
        return torch.optim.SGD(
            network.parameters(), lr=config.learning_rate, momentum=config.momentum, fused=True
        )
    return torch.optim.Adam(network.parameters(), lr=config.learning_rate, fused=True)
