"""Crowds as they were recorded: who was where, and where they wanted to go."""

import dataclasses

import numpy as np

from socialnav_core.states import Agents, CrowdState, Robot

FAR = 1e6  # m; where nobody minds the robot


@dataclasses.dataclass
class Recording:
    """Worlds of equal numbers of people and obstacles; the people's slots come first."""

    time_step: float
    """Time between two moments, s."""
    position: np.ndarray
    """Of the people, m, float32 (worlds, moments, people, 2)."""
    velocity: np.ndarray
    """Of the people, m/s, float32 (worlds, moments, people, 2)."""
    goal: np.ndarray
    """Of the people, m, float32 (worlds, moments, people, 2)."""
    radius: np.ndarray
    """Of people, then obstacles, m, (worlds, agents)."""
    obstacles: np.ndarray
    """Centres, m, (worlds, obstacles, 2)."""

    @property
    def worlds(self) -> int:
        """Return the number of worlds."""
        return self.position.shape[0]

    @property
    def moments(self) -> int:
        """Return the number of moments."""
        return self.position.shape[1]

    @property
    def people(self) -> int:
        """Return the number of people of a world."""
        return self.position.shape[2]

    def state(self, moment: int) -> CrowdState:
        """Return the worlds at a moment, the robot far away."""
        walls = self.obstacles.shape[:2]
        position = np.concatenate([self.position[:, moment], self.obstacles], axis=1)
        velocity = np.concatenate([self.velocity[:, moment], np.zeros((*walls, 2))], axis=1)
        static = np.tile(np.arange(position.shape[1]) >= self.people, (self.worlds, 1))
        agents = Agents(
            position.astype(np.float64), velocity.astype(np.float64), self.radius, static,
            np.ones_like(static),
        )  # fmt: skip
        one = np.ones(self.worlds)
        place = np.full((self.worlds, 2), FAR)
        robot = Robot(place, np.zeros_like(place), 0.0 * one, 0.3 * one, one, place)
        return CrowdState(robot, agents, np.inf * one, self.time_step * moment * one)

    def future(self, world: np.ndarray, moment: np.ndarray, times: np.ndarray) -> np.ndarray:
        """
        Return where people are some times, s, after moments, m, (moments, times, people, 2).

        :param world: of each moment, (moments,).
        """
        exact = times / self.time_step
        before = np.floor(exact + 1e-9).astype(int)
        share = np.maximum(exact - before, 0.0)[None, :, None, None]
        index = moment[:, None] + before
        first = self.position[world[:, None], index]
        after = self.position[world[:, None], np.minimum(index + 1, self.moments - 1)]
        return first + share * (after - first)

    def noisy(
        self, position: float, velocity: float, generator: np.random.Generator
    ) -> 'Recording':
        """Return what sensors with noise of these standard deviations, m and m/s, would see."""
        draws = generator.standard_normal((2, *self.position.shape), np.float32)
        return dataclasses.replace(
            self,
            position=self.position + np.float32(position) * draws[0],
            velocity=self.velocity + np.float32(velocity) * draws[1],
        )
