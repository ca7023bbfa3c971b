"""Where everybody will be when a command takes effect."""

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
    moved = state.agents.velocity * np.where(state.agents.static, 0.0, pedestrian_lag)[..., None]
    return state.with_robot(
        position=state.robot.position + state.robot.velocity * robot_lag,
        heading=state.robot.heading + robot_turn_rate * robot_lag,
    ).with_agents(position=state.agents.position + moved)
