"""ORCA as the robot's planner: the demonstrator of imitation and a baseline."""

import numpy as np

from socialnav_core.config import OrcaConfig
from socialnav_core.policies.straight_line import preferred_velocity
from socialnav_core.simulation.crowds.orca import orca_step
from socialnav_core.simulation.crowds.pedestrians import RADIUS_PADDING, RECIPROCAL
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
        preferred = with_robot(preferred_velocity(state), np.zeros_like(state.position))
        out = np.zeros_like(preferred)
        padding = RADIUS_PADDING + self.safety_space
        orca_step(
            with_robot(state.robot_position, state.position),
            with_robot(state.robot_velocity, state.velocity),
            preferred,
            with_robot(state.robot_radius, state.radius) + padding,
            with_robot(state.robot_preferred_speed, np.zeros_like(state.radius)),
            with_robot(np.ones(state.batch_size, bool), state.valid),
            np.where(
                with_robot(np.zeros(state.batch_size, bool), state.static),
                self.orca.static_responsibility,
                RECIPROCAL,
            ),
            np.full(preferred.shape[:2], self.orca.neighbor_distance),
            np.ones(state.batch_size, bool),
            1,
            self.orca.max_neighbors,
            self.orca.time_horizon,
            self.time_step,
            out,
        )
        return out[:, 0]

    def reset(self) -> None:
        """Do nothing: there is no memory."""


def with_robot(robot: np.ndarray, agents: np.ndarray) -> np.ndarray:
    """
    Return the robot's values followed by those of the agents, (batch, 1 + agents, ...).

    :param robot: (batch, ...).
    :param agents: (batch, agents, ...).
    """
    return np.concatenate([robot[:, None], agents], axis=1)
