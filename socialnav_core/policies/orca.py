"""ORCA as the robot's planner: the demonstrator of imitation and a baseline."""

import dataclasses
import functools
from typing import Annotated

import numpy as np

from socialnav_core.config import OrcaConfig
from socialnav_core.config.ranges import Range, require_allowed
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.straight_line import preferred_velocity
from socialnav_core.simulation.crowds.orca import avoid
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


@dataclasses.dataclass(frozen=True)
class OrcaPolicy:
    """
    Optimal reciprocal collision avoidance, as if everybody shared the effort.

    Pedestrians that do not see the robot do not share it: that is why ORCA collides.
    """

    kinematics = 'holonomic'
    predictor = None
    plan = None

    safety_space: Annotated[float, Range(0, 5)] = 0.15
    """Added to every radius, m."""
    orca: OrcaConfig = OrcaConfig()
    """The other settings of ORCA; its own safety space is not used."""
    time_step: Annotated[float, Range(0.01, 2)] = 0.25
    """Time that a command lasts, s."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)

    @functools.cached_property
    def _settings(self) -> OrcaConfig:
        """Return the settings of ORCA with the safety space of this robot."""
        return dataclasses.replace(self.orca, safety_space=self.safety_space)

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        settings = {'safety_space': self.safety_space}
        return PolicyDescription('orca', self.kinematics, settings=settings)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the commands, (batch, 2)."""
        require_finite(state)
        everybody = state.robot.as_agents().append(state.agents)
        preferred, speed = np.zeros_like(everybody.position), np.zeros_like(everybody.radius)
        preferred[:, 0], speed[:, 0] = preferred_velocity(state), state.robot.preferred_speed
        out = np.zeros_like(preferred)
        every = np.ones(state.batch_size, bool)
        avoid(everybody, preferred, speed, self._settings, self.time_step, every, 1, out)
        return out[:, 0]

    def attention(self, state: CrowdState) -> None:
        """Return nothing: everybody counts as they must."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no memory."""
