"""Where everybody will be when a command takes effect."""

import dataclasses

import numpy as np

from socialnav_core.states import CrowdState


def extrapolate(
    state: CrowdState, robot_lag: float, robot_turn_rate: float, pedestrian_lag: float
) -> CrowdState:
    """
    Return the state moved forward in time at constant velocity.

    :param state: batch of one.
    :param robot_lag: age of the robot's pose at that moment, s.
    :param robot_turn_rate: of the robot, rad/s.
    :param pedestrian_lag: age of the pedestrians' positions at that moment, s.
    """
    moved = state.velocity * np.where(state.static, 0.0, pedestrian_lag)[..., None]
    return dataclasses.replace(
        state,
        robot_position=state.robot_position + state.robot_velocity * robot_lag,
        robot_heading=state.robot_heading + robot_turn_rate * robot_lag,
        position=state.position + moved,
    )
