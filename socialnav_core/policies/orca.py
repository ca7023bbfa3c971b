"""ORCA as the robot's planner: the demonstrator of imitation and a baseline."""

import dataclasses

import numpy as np

from socialnav_core.config import OrcaConfig
from socialnav_core.policies.straight_line import preferred_velocity
from socialnav_core.simulation.crowds.orca import avoid
from socialnav_core.states import CrowdState

SAFETY_SPACE = 0.15
"""Usually added to every radius, m."""


class OrcaPolicy:
    """
    Optimal reciprocal collision avoidance, as if everybody shared the effort.

    Pedestrians that do not see the robot do not share it: that is why ORCA collides.
    """

    kinematics = 'holonomic'

    def __init__(
        self,
        safety_space: float | None = None,
        orca: OrcaConfig | None = None,
        time_step: float = 0.25,
    ) -> None:
        """
        Choose the settings.

        :param safety_space: added to every radius, m; None: SAFETY_SPACE.
        :param orca: the other settings of ORCA; its own safety space is not used.
        :param time_step: s.
        """
        self.safety_space = SAFETY_SPACE if safety_space is None else safety_space
        self.orca = orca or OrcaConfig()
        self.time_step = time_step

    def act(self, state: CrowdState) -> np.ndarray:
        """
        Return the commands, (batch, 2).

        :param state: the worlds as they are.
        """
        everybody = state.robot.as_agents().append(state.agents)
        preferred, speed = np.zeros_like(everybody.position), np.zeros_like(everybody.radius)
        preferred[:, 0], speed[:, 0] = preferred_velocity(state), state.robot.preferred_speed
        out = np.zeros_like(preferred)
        settings = dataclasses.replace(self.orca, safety_space=self.safety_space)
        every = np.ones(state.batch_size, bool)
        avoid(everybody, preferred, speed, settings, self.time_step, every, 1, out)
        return out[:, 0]

    def reset(self) -> None:
        """Do nothing: there is no memory."""
