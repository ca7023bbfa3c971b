"""Social forces as the robot's planner: a baseline."""

import dataclasses
from typing import Annotated

import numpy as np

from socialnav_core.config.ranges import Range, require_allowed
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.straight_line import preferred_velocity
from socialnav_core.simulation.crowds.social_force_kernel import social_force_step
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


@dataclasses.dataclass(frozen=True)
class SocialForcePolicy:
    """
    The goal pulls, people and obstacles push (Helbing and Molnar 1995).

    Walls do not push, and nobody is predicted: everybody else is taken to stand for a step.
    """

    kinematics = 'holonomic'
    predictor = None
    plan = None

    strength: Annotated[float, Range(0, 1000)] = 20.0
    """Acceleration at contact, m/s^2."""
    reach: Annotated[float, Range(0.001, 100)] = 0.15
    """Distance over which it falls to 1 / e, m."""
    relaxation: Annotated[float, Range(0.001, 100)] = 0.5
    """Time in which the preferred velocity is taken up, s."""
    behind: Annotated[float, Range(0, 1)] = 1.0
    """Share of the force of somebody straight behind."""
    time_step: Annotated[float, Range(0.01, 2)] = 0.25
    """Time that a command lasts, s."""

    def __post_init__(self) -> None:
        """Refuse settings that cannot be."""
        require_allowed(self)

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        settings = {'strength': self.strength, 'reach': self.reach}
        return PolicyDescription('social_force', self.kinematics, settings=settings)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the commands, (batch, 2), at most of preferred speed."""
        require_finite(state)
        everybody = state.robot.as_agents().append(state.agents)
        preferred, speed = np.zeros_like(everybody.position), np.zeros_like(everybody.radius)
        preferred[:, 0], speed[:, 0] = preferred_velocity(state), state.robot.preferred_speed
        # far away nobody pushes: padding must not
        position = np.where(everybody.valid[..., None], everybody.position, 1e6)
        out = np.zeros_like(preferred)
        social_force_step(
            position, everybody.velocity, preferred, everybody.radius, speed, 1, self.strength,
            self.reach, self.relaxation, self.behind, self.time_step, out,
        )  # fmt: skip
        length = np.linalg.norm(out[:, 0], axis=-1)
        return out[:, 0] * np.minimum(1.0, speed[:, 0] / np.maximum(length, 1e-9))[:, None]

    def attention(self, state: CrowdState) -> None:
        """Return nothing: everybody pushes by where they are."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no memory."""
