"""What every prediction of people is."""

import dataclasses
from typing import Protocol

import numpy as np

from socialnav_core.states import CrowdState


@dataclasses.dataclass
class Prediction:
    """Where agents will be, in one or more ways that the future may take (modes)."""

    positions: np.ndarray
    """Centres at the times asked for, m, (batch, modes, steps, agents, 2)."""
    deviations: np.ndarray
    """Standard deviation along each axis, m, (batch, modes, steps, agents)."""
    weights: np.ndarray
    """Probabilities of the modes, sum to one, (batch, modes)."""


class Predictor(Protocol):
    """Says where the agents of each world will be."""

    knowledge: str
    """What it knows: deployable (what a robot can), model-matched (how people move), or oracle."""

    def predict(self, state: CrowdState, times: np.ndarray) -> Prediction:
        """Return where the agents will be at some times ahead, s, (steps,)."""
        ...

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the history of some worlds, of all where none are named."""
        ...
