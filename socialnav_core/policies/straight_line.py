"""Straight to the goal, blind: the baseline that shows how hard a world is."""

import numpy as np

from socialnav_core.states import CrowdState


class StraightLinePolicy:
    """Drive towards the goal at preferred speed whatever is in the way."""

    kinematics = 'holonomic'

    def act(self, state: CrowdState) -> np.ndarray:
        """
        Return the commands, (batch, 2); slower within the last metre.

        :param state: the worlds as they are.
        """
        return preferred_velocity(state)

    def reset(self) -> None:
        """Do nothing: there is no memory."""


def preferred_velocity(state: CrowdState) -> np.ndarray:
    """
    Return the velocity of a robot that is alone, m/s, (batch, 2).

    :param state: the worlds as they are.
    """
    ahead = state.robot.goal - state.robot.position
    distance = np.linalg.norm(ahead, axis=-1, keepdims=True)
    return ahead / np.maximum(distance, 1.0) * state.robot.preferred_speed[:, None]
