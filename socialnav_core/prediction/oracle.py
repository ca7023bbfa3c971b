"""Prediction by asking the simulator: the bound on what a prediction of one step can bring."""

from collections.abc import Callable
import dataclasses

import numpy as np

from socialnav_core.config import ConfigError
from socialnav_core.prediction.protocol import Prediction, Predictor
from socialnav_core.states import CrowdState


@dataclasses.dataclass
class Oracle:
    """
    Everybody does in the coming step what the simulator has decided, and goes straight on after.

    It is certain of all that, so no more than the coming step is to be asked for.
    """

    knowledge = 'oracle'
    remembers = False

    next_velocities: Callable[[], np.ndarray] | None = None
    """Returns the agents' velocities in the coming step, m/s, (batch, agents, 2)."""

    def predict(self, state: CrowdState, times: np.ndarray) -> Prediction:
        """
        Return where the agents will be at some times ahead, s, (steps,).

        :raises ConfigError: where no simulator is attached.
        """
        if self.next_velocities is None:
            raise ConfigError(
                'the oracle look-ahead exists in simulation only; use constant_velocity'
            )
        velocities, ahead = self.next_velocities(), np.asarray(times)[:, None, None]
        positions = state.agents.position[:, None] + velocities[:, None] * ahead
        certain = np.zeros(positions.shape[:-1])
        weights = np.ones((len(positions), 1))
        return Prediction(positions[:, None], certain[:, None], weights, velocities[:, None])

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no history."""


def attach_simulator(
    predictor: Predictor | None, next_velocities: Callable[[], np.ndarray]
) -> None:
    """
    Let an oracle ask a simulator; other predictors are left as they are.

    :param next_velocities: returns those of the worlds that the oracle is asked about next.
    """
    if isinstance(predictor, Oracle):
        predictor.next_velocities = next_velocities
