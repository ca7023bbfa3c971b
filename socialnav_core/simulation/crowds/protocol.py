"""What every crowd is, and where the simulator gets one."""

import importlib
from typing import Protocol

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes


class Crowd(Protocol):
    """
    Moves the people of a batch of worlds.

    The crowd that scenarios call NAME is what `make_crowd(scenario, batch_size)` in
    `crowds/NAME.py` returns; `CROWDS` in config/scenario.py lists the names. Randomness comes from
    `episodes.goal_streams`, or from streams that the crowd keeps among its own state.
    """

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """
        Begin anew in some worlds, which have just been laid out.

        :param episodes: all worlds; where people start and want to go may be changed.
        :param worlds: indices.
        """
        ...

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """
        Choose the velocities of the people for the scenario's time step.

        :param episodes: the worlds; `episodes.scenario` tells who is seen.
        :param due: worlds to decide in, bool (batch,).
        :param velocities: m/s, (batch, agents, 2), written where that is due; zero for obstacles.
        """
        ...

    def renew_goals(self, episodes: Episodes) -> None:
        """
        Give another goal to whoever has arrived; called after steps where scenarios ask for it.

        :raises PackingError: when there is no place for a goal.
        """
        ...

    def get_state(self) -> dict[str, np.ndarray]:
        """Return copies of all that is remembered, so that a run goes on as if never stopped."""
        ...

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from where `get_state` returned these arrays."""
        ...


def make_crowd(scenario: Scenario, batch_size: int) -> Crowd:
    """Return the crowd that a scenario names; configurations have checked the name."""
    module = importlib.import_module(f'socialnav_core.simulation.crowds.{scenario.crowd}')
    return module.make_crowd(scenario, batch_size)
