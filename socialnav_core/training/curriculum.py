"""Obstacles that grow with success: Algorithm 1 of the founding report, and its alternatives."""

import dataclasses

import numpy as np

from socialnav_core.config import CurriculumConfig, Scenario
from socialnav_core.config.scenarios import with_obstacle_radius
from socialnav_core.simulation import Simulator
from socialnav_core.training.episodes import EpisodeWindow
from socialnav_core.training.randomness import generator, Purpose


class Curriculum:
    """The present level and the latest episodes that were begun at it."""

    def __init__(self, config: CurriculumConfig, next_case: int, seed: int = 0) -> None:
        """
        Begin at the first level.

        :param next_case: case index of the first episode.
        :param seed: of the run; baby steps are drawn by it.
        """
        self.config = config
        self.level = 0
        self.window = EpisodeWindow(config.window, next_case)
        self._seed = seed

    @property
    def radius(self) -> float:
        """Return the largest obstacle radius of the level, m."""
        return self.radius_of(self.level)

    def radius_of(self, level: int) -> float:
        """
        Return the largest obstacle radius of a level, m.

        :param level: from 0.
        """
        config = self.config
        return min(config.start_radius + level * config.radius_step, config.final_radius)

    def scenario(self, scenario: Scenario, level: int | None = None) -> Scenario:
        """
        Return a scenario with the obstacles of a level.

        The hardest ones have the level's radius. The others lie between the scenario's smallest
        radius and it (smooth), or between the previous level's and it (baby_step, one_pass), as
        far as so many large obstacles find room.

        :param level: None for the present one.
        """
        level = self.level if level is None else level
        grown = with_obstacle_radius(scenario, self.radius_of(level))
        if self.config.scheduler == 'smooth' or level == 0:
            return grown
        smallest = min(self.radius_of(level - 1), self.config.largest_minimum)
        smallest = max(smallest, scenario.obstacle_radius_min)
        return dataclasses.replace(grown, obstacle_radius_min=smallest)

    def bucket(self, case: int) -> int:
        """
        Return the level whose obstacles a case has, were it to begin now.

        In baby steps it is any of the levels opened so far, all equally likely; otherwise the
        present one.
        """
        if self.config.scheduler != 'baby_step':
            return self.level
        return int(generator(self._seed, Purpose.BUCKET, case).integers(self.level + 1))

    def apply(self, simulator: Simulator, scenario: Scenario) -> None:
        """Let the episodes that begin from now on have the obstacles of the present level."""
        scenarios = [self.scenario(scenario, level) for level in range(self.level + 1)]
        mixed = self.config.scheduler == 'baby_step'
        simulator.change_scenario(
            scenarios[-1], (lambda case: scenarios[self.bucket(case)]) if mixed else None
        )

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
        """Continue from a stored state."""
        self.level = int(state['level'])
        self.window.set_state(state)
