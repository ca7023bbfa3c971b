"""A crowd that remembers nothing."""

from collections.abc import Callable
import dataclasses

import numpy as np

from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import renew_goals


@dataclasses.dataclass(frozen=True)
class Memoryless:
    """A Crowd made of functions of the worlds as they are."""

    decide: Callable[[Episodes, np.ndarray, np.ndarray], None]
    """As Crowd.decide."""
    renew_goals: Callable[[Episodes], None] = renew_goals
    """As Crowd.renew_goals."""

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Do nothing."""

    def get_state(self) -> dict[str, np.ndarray]:
        """Return nothing."""
        return {}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Do nothing."""
