"""observe(): the only code that turns the world into what a network sees."""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.simulation.kinematics import Holonomic, Kinematics
from socialnav_core.states import CrowdState, Observation

ROBOT_FEATURES = 6
AGENT_FEATURES = 7
HOLONOMIC = Holonomic()


def observe(state: CrowdState, kinematics: Kinematics = HOLONOMIC) -> Observation:
    """
    Return the robot-centred features of each world: robot (batch, 6), others (batch, agents, 7).

    The origin is the robot and the x axis points at its goal. The heading feature is that of a
    differential drive, relative to the x axis; a holonomic robot's is zero.
    """
    seen = observe_candidates(
        state,
        state.robot.position[:, None],
        state.robot.velocity[:, None],
        state.robot.heading[:, None],
        state.agents.position,
        state.agents.velocity,
        kinematics,
    )
    return Observation(seen.robot[:, 0], seen.others[:, 0], seen.mask)


def observe_candidates(
    state: CrowdState,
    robot_position: np.ndarray,
    robot_velocity: np.ndarray,
    robot_heading: np.ndarray,
    position: np.ndarray,
    velocity: np.ndarray,
    kinematics: Kinematics = HOLONOMIC,
) -> Observation:
    """
    Return what each world would look like for several candidate states of its robot.

    Shapes: robot (batch, candidates, 6), others (batch, candidates, agents, 7), mask (batch,
    agents), the same for all candidates.

    :param state: gives what does not change: radii, goals, masks.
    :param robot_position: m, (batch, candidates, 2).
    :param robot_velocity: m/s, (batch, candidates, 2).
    :param robot_heading: rad, (batch, candidates).
    :param position: of the agents, m, (batch, agents, 2).
    :param velocity: of the agents, m/s, (batch, agents, 2).
    """
    batch, candidates = robot_position.shape[:2]
    robot = np.empty((batch, candidates, ROBOT_FEATURES), np.float32)
    others = np.empty((batch, candidates, state.agents.count, AGENT_FEATURES), np.float32)
    _fill(
        robot_position, robot_velocity, robot_heading, kinematics.has_heading,
        state.robot.goal, state.robot.preferred_speed, state.robot.radius, position, velocity,
        state.agents.radius, state.agents.valid, robot, others,
    )  # fmt: skip
    return Observation(robot, others, state.agents.valid)


@compiled
def _fill(  # type: ignore[no-untyped-def]
    robot_position, robot_velocity, robot_heading, has_heading, goal, preferred_speed,
    robot_radius, position, velocity, radius, valid, robot, others,
):  # fmt: skip
    """Fill robot and others; the features of padding are zero."""
    for world in range(robot.shape[0]):
        for k in range(robot.shape[1]):
            x, y = robot_position[world, k, 0], robot_position[world, k, 1]
            goal_x, goal_y = goal[world, 0] - x, goal[world, 1] - y
            goal_distance = math.sqrt(goal_x * goal_x + goal_y * goal_y)
            cosine, sine = 1.0, 0.0
            if goal_distance > 0.0:
                cosine, sine = goal_x / goal_distance, goal_y / goal_distance
            vx, vy = robot_velocity[world, k, 0], robot_velocity[world, k, 1]
            robot[world, k, 0] = goal_distance
            robot[world, k, 1] = preferred_speed[world]
            robot[world, k, 2] = 0.0
            if has_heading:
                angle = robot_heading[world, k] - math.atan2(sine, cosine)
                robot[world, k, 2] = (angle + math.pi) % (2.0 * math.pi) - math.pi
            robot[world, k, 3] = robot_radius[world]
            robot[world, k, 4] = vx * cosine + vy * sine
            robot[world, k, 5] = vy * cosine - vx * sine
            for i in range(position.shape[1]):
                if not valid[world, i]:
                    others[world, k, i] = 0.0
                    continue
                px, py = position[world, i, 0] - x, position[world, i, 1] - y
                vx, vy = velocity[world, i, 0], velocity[world, i, 1]
                others[world, k, i, 0] = px * cosine + py * sine
                others[world, k, i, 1] = py * cosine - px * sine
                others[world, k, i, 2] = vx * cosine + vy * sine
                others[world, k, i, 3] = vy * cosine - vx * sine
                others[world, k, i, 4] = radius[world, i]
                others[world, k, i, 5] = math.sqrt(px * px + py * py)
                others[world, k, i, 6] = radius[world, i] + robot_radius[world]
