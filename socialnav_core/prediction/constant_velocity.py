"""Prediction by constant velocity: the baseline, and what needs no history."""

import dataclasses
from typing import Annotated

import numpy as np

from socialnav_core.config.ranges import Range, require_allowed
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

    deviation: Annotated[float, Range(1e-06, 10)] = 0.03
    """Standard deviation of a walker's position at once, m."""
    deviation_growth: Annotated[float, Range(0, 10)] = 0.12
    """What is added to it in a second, m/s."""
    standing_deviation: Annotated[float, Range(1e-06, 10)] = 0.03
    """Standard deviation of the position of whoever stands, m."""
    static_deviation: Annotated[float, Range(1e-06, 10)] = 0.001
    """Standard deviation of the position of an obstacle, m."""
    standing_speed: Annotated[float, Range(0, 10)] = 0.05
    """Below this speed somebody stands, m/s."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)

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
