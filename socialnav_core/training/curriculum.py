"""Obstacles that grow with success: Algorithm 1 of the founding report."""

import numpy as np

from socialnav_core.config import CurriculumConfig, Scenario
from socialnav_core.simulation.scenarios import with_obstacle_radius
from socialnav_core.training.episodes import EpisodeWindow


class Curriculum:
    """The present level and the latest episodes that were begun at it."""

    def __init__(self, config: CurriculumConfig, next_case: int) -> None:
        """
        Begin at the first level.

        :param config: levels and what opens the next.
        :param next_case: case index of the first episode.
        """
        self.config = config
        self.level = 0
        self.window = EpisodeWindow(config.window, next_case)

    @property
    def radius(self) -> float:
        """Return the largest obstacle radius of the level, m."""
        config = self.config
        return min(config.start_radius + self.level * config.radius_step, config.final_radius)

    def scenario(self, scenario: Scenario) -> Scenario:
        """
        Return a scenario with the obstacles of the level.

        :param scenario: everything else.
        """
        return with_obstacle_radius(scenario, self.radius)

    def advance(self, next_case: int) -> bool:
        """
        Go to the next level if enough of the latest episodes of this one succeeded.

        :param next_case: case index of the first episode that will begin at the next level.
        """
        passed = self.window.full and self.window.success_rate >= self.config.target_success
        if not passed or self.radius >= self.config.final_radius:
            return False
        self.level += 1
        self.window.restart(next_case)
        return True

    def get_state(self) -> dict[str, np.ndarray]:
        """Return what set_state needs to continue from here."""
        return self.window.get_state() | {'level': np.array(self.level)}

    def set_state(self, state: dict[str, np.ndarray]) -> None:
        """
        Continue from a stored state.

        :param state: from get_state.
        """
        self.level = int(state['level'])
        self.window.set_state(state)
