"""The network in torch, and the loss that it is trained by."""

import itertools

import numpy as np
import torch
from torch import nn

from socialnav_core.config.prediction import PredictionTrainingConfig
from socialnav_core.prediction.learned.layout import DOUBT, INPUTS, OUTPUTS, SCALE, STEPS
from socialnav_core.prediction.learned.outputs import GREATEST_LOGARITHM, LEAST_LOGARITHM
from socialnav_core.training.prediction.examples import Examples

GOAL = 2
"""Auxiliary outputs, not kept: direction to the goal; logarithms of Student's scales follow."""
LOGARITHMS = LEAST_LOGARITHM, GREATEST_LOGARITHM


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
        return nn.Sequential(*hidden, nn.Linear(width, OUTPUTS + GOAL + STEPS))


def inference_weights(network: nn.Sequential) -> dict[str, np.ndarray]:
    """Return copies of what inference needs of the weights, layers numbered from 0."""
    linear = [layer for layer in network if isinstance(layer, nn.Linear)]
    weights = {}
    for number, layer in enumerate(linear):
        rows = OUTPUTS if layer is linear[-1] else layer.out_features
        weights[f'{number}.weight'] = layer.weight.detach().numpy()[:rows].copy()
        weights[f'{number}.bias'] = layer.bias.detach().numpy()[:rows].copy()
    return weights


def calibrated(weights: dict[str, np.ndarray], factors: np.ndarray) -> dict[str, np.ndarray]:
    """Return weights whose deviations at each moment are some times as large, (STEPS,)."""
    last = f'{max(int(name.partition(".")[0]) for name in weights)}.bias'
    bias = weights[last].copy()
    bias[2 * STEPS : OUTPUTS] += np.log(factors).astype(np.float32)
    return weights | {last: bias}


def loss_of(
    network: nn.Sequential, examples: Examples, config: PredictionTrainingConfig
) -> torch.Tensor:
    """
    Return how improbable and how far off the truth is, and how wrong the direction of the goal.

    The means learn by Student's t, whose tails let the few who turn at once leave the prediction
    of the many alone. The deviations learn to be those of a Gaussian about the means. All
    distances are in units of SCALE, so that no moment outweighs the others.
    """
    output = network(torch.from_numpy(examples.features))
    truth = torch.from_numpy(examples.residual) / torch.from_numpy(SCALE)[:, None]
    square = (truth - believed(output)).square().sum(-1)
    tails, scale = config.degrees_of_freedom, output[:, OUTPUTS + GOAL :].clamp(*LOGARITHMS)
    relative = square * torch.exp(-2.0 * scale) / tails
    heavy = (0.5 * (tails + 2.0) * torch.log1p(relative) + 2.0 * scale).mean()
    deviation = output[:, 2 * STEPS : OUTPUTS].clamp(*LOGARITHMS)
    gaussian = (0.5 * square.detach() * torch.exp(-2.0 * deviation) + 2.0 * deviation).mean()
    distance = torch.sqrt(square + 1e-4).mean()
    aim = output[:, OUTPUTS : OUTPUTS + GOAL]
    goal = (aim - torch.from_numpy(examples.goal)).square().sum(-1).mean()
    return heavy + gaussian + config.distance_weight * distance + config.goal_weight * goal


def believed(output: torch.Tensor) -> torch.Tensor:
    """Return what inference makes of outputs: residuals in units of SCALE, (people, STEPS, 2)."""
    residual = output[:, : 2 * STEPS].reshape(-1, STEPS, 2)
    square = residual.square().sum(-1, keepdim=True)
    return residual * (square / (square + DOUBT**2))
