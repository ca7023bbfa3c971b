"""What every prediction of the people around the robot is."""

import dataclasses
from typing import Protocol

import numpy as np

from socialnav_core.states import CrowdState


@dataclasses.dataclass
class Prediction:
    """Where the agents of each world will be, in one or several modes."""

    positions: np.ndarray
    """Expected centres at the times asked for, m, (batch, modes, steps, agents, 2)."""
    deviations: np.ndarray
    """Standard deviations along each axis, m, (batch, modes, steps, agents)."""
    weights: np.ndarray
    """Probabilities of the modes, which sum to one, (batch, modes)."""


class Predictor(Protocol):
    """Says where people will be; it may remember where they were."""

    knowledge: str
    """deployable: sees what a robot sees; model-matched: knows the simulator's laws; oracle."""

    def predict(self, state: CrowdState, times: np.ndarray) -> Prediction:
        """
        Return where the agents of a state will be.

        :param times: from the time of the state, s, (steps,).
        """
        ...

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """
        Forget the history of some worlds.

        :param worlds: indices or a mask; None for all.
        """
        ...
