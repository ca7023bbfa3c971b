"""Straight to the goal, blind: the baseline that shows how hard a world is."""

import dataclasses

import numpy as np

from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


@dataclasses.dataclass
class StraightLinePolicy:
    """Drive towards the goal at preferred speed whatever is in the way."""

    kinematics = 'holonomic'
    predictor = None
    plan = None

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        return PolicyDescription('straight_line', self.kinematics)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the commands, (batch, 2); slower within the last metre."""
        require_finite(state)
        return preferred_velocity(state)

    def attention(self, state: CrowdState) -> None:
        """Return nothing: it looks at nobody."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no memory."""


def preferred_velocity(state: CrowdState) -> np.ndarray:
    """Return the velocity of a robot that is alone, m/s, (batch, 2)."""
    ahead = state.robot.goal - state.robot.position
    distance = np.linalg.norm(ahead, axis=-1, keepdims=True)
    return ahead / np.maximum(distance, 1.0) * state.robot.preferred_speed[:, None]
