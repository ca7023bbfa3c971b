"""One gradient step of the value network towards its targets."""

import torch
from torch import nn

from socialnav_core.policies.value.inference import device_of


def regress(
    network: nn.Module,
    optimizer: torch.optim.Optimizer,
    batch: tuple[torch.Tensor, ...],
    learning_rate: float,
    gradient_clip: float,
    bfloat16: bool,
) -> float:
    """
    Move the network towards the targets by the mean squared error; return that error.

    :param network: value network, float32.
    :param optimizer: of the network's parameters.
    :param batch: robot (batch, 6), others (batch, agents, 7), mask and target (batch,).
    :param learning_rate: of this step.
    :param gradient_clip: largest norm of the gradient.
    :param bfloat16: whether products are computed in bfloat16.
    :raises FloatingPointError: when the error is not a number.
    """
    device = device_of(network)
    robot, others, mask, target = (tensor.to(device) for tensor in batch)
    for group in optimizer.param_groups:
        group['lr'] = learning_rate
    with torch.autocast(device.type, torch.bfloat16, enabled=bfloat16):
        value = network(robot, others, mask)
    loss = nn.functional.mse_loss(value.float(), target)
    optimizer.zero_grad()
    loss.backward()
    norm = nn.utils.clip_grad_norm_(network.parameters(), gradient_clip)
    if not torch.isfinite(norm):
        raise FloatingPointError('the loss is not a number; lower training.learning_rate')
    optimizer.step()
    return loss.item()
