"""The network in torch, and the loss that it is trained by."""

import itertools

import numpy as np
import torch
from torch import nn

from socialnav_core.config.prediction import PredictionTrainingConfig
from socialnav_core.prediction.learned.layout import INPUTS, OUTPUTS, SCALE, STEPS
from socialnav_core.prediction.learned.outputs import GREATEST_LOGARITHM, LEAST_LOGARITHM
from socialnav_core.training.prediction.examples import Examples

GOAL = 2
"""Auxiliary outputs: the direction to the goal; they are not kept."""


def build_network(width: int, seed: int) -> nn.Sequential:
    """Return the network with random weights, leaving torch's own generator as it was."""
    sizes = (INPUTS, width, width, width)
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        hidden = [
            layer
            for before, after in itertools.pairwise(sizes)
            for layer in (nn.Linear(before, after), nn.SiLU())
        ]
        return nn.Sequential(*hidden, nn.Linear(width, OUTPUTS + GOAL))


def inference_weights(network: nn.Sequential) -> dict[str, np.ndarray]:
    """Return copies of what inference needs of the weights, layers numbered from 0."""
    linear = [layer for layer in network if isinstance(layer, nn.Linear)]
    weights = {}
    for number, layer in enumerate(linear):
        rows = OUTPUTS if layer is linear[-1] else layer.out_features
        weights[f'{number}.weight'] = layer.weight.detach().numpy()[:rows].copy()
        weights[f'{number}.bias'] = layer.bias.detach().numpy()[:rows].copy()
    return weights


def loss_of(
    network: nn.Sequential, examples: Examples, config: PredictionTrainingConfig
) -> torch.Tensor:
    """
    Return the Gaussian negative log-likelihood plus distance and direction of the goal.

    All distances are in units of SCALE, so that no moment outweighs the others.
    """
    output = network(torch.from_numpy(examples.features))
    mean = output[:, : 2 * STEPS].reshape(-1, STEPS, 2)
    logarithm = output[:, 2 * STEPS : OUTPUTS].clamp(LEAST_LOGARITHM, GREATEST_LOGARITHM)
    truth = torch.from_numpy(examples.residual) / torch.from_numpy(SCALE)[:, None]
    square = (truth - mean).square().sum(-1)
    likelihood = (0.5 * square * torch.exp(-2.0 * logarithm) + 2.0 * logarithm).mean()
    distance = torch.sqrt(square + 1e-4).mean()
    goal = (output[:, OUTPUTS:] - torch.from_numpy(examples.goal)).square().sum(-1).mean()
    return likelihood + config.distance_weight * distance + config.goal_weight * goal
