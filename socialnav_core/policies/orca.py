"""ORCA as the robot's planner: the demonstrator of imitation and a baseline."""

import dataclasses

import numpy as np

from socialnav_core.config import OrcaConfig, require
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

    safety_space: float = 0.15
    """Added to every radius, m."""
    orca: OrcaConfig = OrcaConfig()
    """The other settings of ORCA; its own safety space is not used."""
    time_step: float = 0.25
    """Time that a command lasts, s."""

    def __post_init__(self) -> None:
        """Refuse settings that cannot be."""
        require(0.0 <= self.safety_space < np.inf, 'safety_space must be at least 0 m')
        require(0.0 < self.time_step < np.inf, 'time_step must be more than 0 s')

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        settings = {'safety_space': self.safety_space}
        return PolicyDescription('orca', self.kinematics, settings=settings)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the commands, (batch, 2)."""
        everybody = state.robot.as_agents().append(state.agents)
        preferred, speed = np.zeros_like(everybody.position), np.zeros_like(everybody.radius)
        preferred[:, 0], speed[:, 0] = preferred_velocity(state), state.robot.preferred_speed
        out = np.zeros_like(preferred)
        settings = dataclasses.replace(self.orca, safety_space=self.safety_space)
        every = np.ones(state.batch_size, bool)
        avoid(everybody, preferred, speed, settings, self.time_step, every, 1, out)
        return out[:, 0]

    def attention(self, state: CrowdState) -> None:
        """Return nothing: everybody counts as they must."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no memory."""
