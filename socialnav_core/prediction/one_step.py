"""A prediction as a look-ahead of one step needs it: one velocity for each agent."""

import numpy as np

from socialnav_core.prediction.protocol import Prediction
from socialnav_core.states import CrowdState


def one_step(
    prediction: Prediction, state: CrowdState, duration: float
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return the velocity of each agent over a step, and how uncertain its end is.

    Several modes are taken together, with the mean and the standard deviation of the mixture.

    :param prediction: at one time, the end of the step.
    :returns: velocities, m/s, (batch, agents, 2), and standard deviations along each axis, m,
        (batch, agents).
    """
    velocities = prediction.velocities
    if velocities is None:
        start = state.agents.position[:, None]
        velocities = (prediction.positions[:, :, 0] - start) / duration
    deviations = prediction.deviations[:, :, 0]
    if velocities.shape[1] == 1:
        return velocities[:, 0], deviations[:, 0]
    weights = prediction.weights[:, :, None]
    mean = (weights[..., None] * velocities).sum(axis=1)
    apart = np.square(velocities - mean[:, None]).mean(axis=-1) * duration**2  # of either axis
    return mean, np.sqrt((weights * (np.square(deviations) + apart)).sum(axis=1))
