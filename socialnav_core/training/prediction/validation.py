"""How good the weights are on crowds of the validation split."""

import dataclasses

import numpy as np
import torch
from torch import nn

from socialnav_core.config.prediction import PredictionConfig, PredictionTrainingConfig
from socialnav_core.prediction.learned.layout import OUTPUTS, SCALE, STEPS, TIMES
from socialnav_core.training.prediction.dataset import record_crowds
from socialnav_core.training.prediction.examples import draw_examples, Examples
from socialnav_core.training.prediction.network import believed, loss_of
from socialnav_core.training.randomness import generator, Purpose

MOMENTS = 40
"""Moments of each recording."""
TWO = 0.954
"""Share of a Gaussian within two standard deviations."""


def validation_examples(config: PredictionConfig) -> list[Examples]:
    """Return the same examples at every call, noise and all, one batch a recording."""
    noise = config.training.noise
    return [
        draw_examples(
            [crowd], MOMENTS, noise, generator(config.seed, Purpose.VALIDATION_EXAMPLES, number)
        )
        for number, crowd in enumerate(record_crowds(config.crowds, config.seed, 'validation'))
    ]


@dataclasses.dataclass(frozen=True)
class Validation:
    """Means over all people."""

    loss: float
    """As in training."""
    error_1s: float
    """Distance between prediction and truth after 1 s, m."""
    error_3s: float
    """The same after 3 s."""
    factors: np.ndarray
    """What to multiply the deviations at each moment by, so that they hold, (STEPS,)."""


def validate(
    network: nn.Sequential, batches: list[Examples], config: PredictionTrainingConfig
) -> Validation:
    """Return how the network does on some examples."""
    losses, errors, ratios, people = [], [], [], []
    with torch.inference_mode():
        for batch in batches:
            losses.append(loss_of(network, batch, config).item())
            output = network(torch.from_numpy(batch.features))
            logarithm = output[:, 2 * STEPS : OUTPUTS].numpy()
            miss = believed(output).numpy() * SCALE[:, None] - batch.residual
            errors.append(np.linalg.norm(miss, axis=-1).mean(axis=0))
            ratios.append(np.abs(miss) / (np.exp(logarithm) * SCALE)[..., None])
            people.append(len(batch.features))
    error = np.average(errors, axis=0, weights=people)
    return Validation(
        float(np.average(losses, weights=people)),
        float(error[TIMES == 1.0][0]),
        float(error[-1]),
        calibration(np.concatenate(ratios)),
    )


def calibration(ratios: np.ndarray) -> np.ndarray:
    """
    Return the factors with which as many errors as a Gaussian has are within two deviations.

    Within one there are more than a Gaussian has: most people walk straight on, a few turn.

    :param ratios: errors along each axis in units of the deviations, (people, STEPS, 2).
    """
    return 0.5 * np.quantile(ratios, TWO, axis=(0, 2))
