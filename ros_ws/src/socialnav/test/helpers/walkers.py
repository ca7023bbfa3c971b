"""People who walk back and forth, and let others pass."""

import numpy as np

RADIUS, SPEED, NEAR = 0.3, 0.9, 1.1
"""Of everybody, m; m/s; distance to what is in front at which one stops, between centres, m."""
ANGLE = 0.5
"""Cosine of the angle to either side up to which something is in front."""


class Walkers:
    """Everybody walks to a place of its own, then to another."""

    def __init__(self, count: int, half_width: float, seed: int) -> None:
        """
        Place people at random.

        :param half_width: of the square around the origin that they walk in, m.
        """
        self._random, self._half_width = np.random.default_rng(seed), half_width
        self.position = self._anywhere(count)
        self.velocity = np.zeros((count, 2))
        self._goal = self._anywhere(count)

    def advance(self, duration: float, robots: np.ndarray) -> None:
        """
        Walk for some time, s.

        :param robots: their places, whom everybody lets pass, m, (robots, 2).
        """
        way = self._goal - self.position
        distance = np.hypot(*way.T)
        direction = way / np.maximum(distance, 1e-9)[:, None]
        others = np.concatenate([self.position, robots])
        to_others = others - self.position[:, None]
        gap = np.hypot(to_others[..., 0], to_others[..., 1])
        ahead = (to_others * direction[:, None]).sum(axis=-1) > ANGLE * gap
        waits = (ahead & (gap < NEAR) & (gap > 0)).any(axis=1)
        self.velocity = np.where(waits[:, None], 0.0, SPEED * direction)
        self.position = self.position + self.velocity * duration
        # who is there, or has waited for long enough, goes somewhere else
        done = (distance < 0.3) | (waits & (self._random.random(len(way)) < duration / 2))
        self._goal[done] = self._anywhere(int(done.sum()))

    def _anywhere(self, count: int) -> np.ndarray:
        """Return places, m, (count, 2)."""
        return self._random.uniform(-self._half_width, self._half_width, (count, 2))
