"""One gradient step of the value network towards its targets."""

import torch
from torch import nn

from socialnav_core.policies.value.inference import device_of


def value_loss(
    network: nn.Module, batch: tuple[torch.Tensor, ...], bfloat16: bool
) -> torch.Tensor:
    """
    Return the mean squared error of the network's values, a float32 scalar.

    :param batch: robot (batch, 6), others (batch, agents, 7), mask and target (batch,).
    :param bfloat16: whether products are computed in bfloat16.
    """
    device = device_of(network)
    robot, others, mask, target = (tensor.to(device) for tensor in batch)
    with torch.autocast(device.type, torch.bfloat16, enabled=bfloat16):
        value = network(robot, others, mask)
    return nn.functional.mse_loss(value.float(), target)


def update(
    network: nn.Module,
    optimizer: torch.optim.Optimizer,
    loss: torch.Tensor,
    learning_rate: float,
    gradient_clip: float,
) -> None:
    """
    Make one step down the gradient of the loss.

    :param gradient_clip: largest norm of the gradient.
    :raises FloatingPointError: when the gradient is not finite.
    """
    for group in optimizer.param_groups:
        group['lr'] = learning_rate
    optimizer.zero_grad()
    loss.backward()
    norm = nn.utils.clip_grad_norm_(network.parameters(), gradient_clip)
    if not torch.isfinite(norm):
        raise FloatingPointError('the loss is not a number; lower training.learning_rate')
    optimizer.step()
