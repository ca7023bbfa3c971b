"""Prediction by constant velocity: the baseline, and what needs no history."""

import dataclasses

import numpy as np

from socialnav_core.config import require
from socialnav_core.prediction.protocol import Prediction
from socialnav_core.states import CrowdState


@dataclasses.dataclass(frozen=True)
class ConstantVelocity:
    """
    Everybody keeps the velocity that they have.

    The standard deviation of a walker grows linearly with time; whoever stands stays.
    """

    knowledge = 'deployable'
    remembers = False

    deviation: float = 0.03
    """Standard deviation of a walker's position at once, m."""
    deviation_growth: float = 0.12
    """What is added to it in a second, m/s."""
    standing_deviation: float = 0.03
    """Standard deviation of the position of whoever stands, m."""
    static_deviation: float = 0.001
    """Standard deviation of the position of an obstacle, m."""
    standing_speed: float = 0.05
    """Below this speed somebody stands, m/s."""

    def __post_init__(self) -> None:
        """Refuse deviations that are none."""
        for field in dataclasses.fields(self):
            require(getattr(self, field.name) >= 0, f'{field.name} must not be negative')
        for name in ('deviation', 'standing_deviation', 'static_deviation'):
            require(getattr(self, name) > 0, f'{name} must be positive')

    def predict(self, state: CrowdState, times: np.ndarray) -> Prediction:
        """Return where the agents will be at some times ahead, s, (steps,)."""
        agents, ahead = state.agents, np.asarray(times)[:, None]
        positions = agents.position[:, None] + agents.velocity[:, None] * ahead[..., None]
        speed = np.hypot(agents.velocity[..., 0], agents.velocity[..., 1])
        stands = speed < self.standing_speed
        now = np.where(stands, self.standing_deviation, self.deviation)
        now = np.where(agents.static, self.static_deviation, now)
        growth = np.where(stands | agents.static, 0.0, self.deviation_growth)
        deviations = now[:, None] + growth[:, None] * ahead
        weights = np.ones((len(now), 1))
        return Prediction(
            positions[:, None], deviations[:, None], weights, agents.velocity[:, None]
        )

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no history."""
