"""What a step of the robot leads to and what it is worth."""

import enum
import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import RewardConfig
from socialnav_core.states import CrowdState


class Outcome(enum.IntEnum):
    """How a step ended; the first that applies, in this order, after NONE."""

    NONE = 0
    COLLISION_PEDESTRIAN = 1
    COLLISION_OBSTACLE = 2
    OUT_OF_BOUNDS = 3
    GOAL = 4
    TIMEOUT = 5


_NONE, _PEDESTRIAN, _OBSTACLE, _OUT, _GOAL, _TIMEOUT = (int(outcome) for outcome in Outcome)


class RewardSettings(NamedTuple):
    """What the kernel takes of a RewardConfig, and the distance at which a goal is reached, m."""

    goal: float
    collision: float
    out_of_bounds: float
    discomfort_distance: float
    discomfort_factor: float
    walls_discomfort: bool
    goal_tolerance: float


class Scene(NamedTuple):
    """Everybody before a step; shapes and units as in CrowdState, velocities those of the step."""

    robot_position: np.ndarray
    robot_radius: np.ndarray
    goal: np.ndarray
    position: np.ndarray
    velocity: np.ndarray
    radius: np.ndarray
    static: np.ndarray
    valid: np.ndarray
    bounds: np.ndarray


class Judgement(NamedTuple):
    """What candidate motions of the robot lead to, (batch, candidates) each."""

    reward: np.ndarray
    """float64."""
    outcome: np.ndarray
    """Codes of Outcome, int8, never TIMEOUT."""
    clearance: np.ndarray
    """Least gap of rims to any agent, m, inf where there is nobody."""
    pedestrian_clearance: np.ndarray
    """Least gap of rims to a pedestrian, m."""


def reward_settings(reward: RewardConfig, goal_tolerance: float) -> RewardSettings:
    """Return the settings that the kernel takes."""
    return RewardSettings(
        goal=reward.goal,
        collision=reward.collision,
        out_of_bounds=reward.out_of_bounds,
        discomfort_distance=reward.discomfort_distance,
        discomfort_factor=reward.discomfort_factor,
        walls_discomfort=reward.walls_discomfort,
        goal_tolerance=goal_tolerance,
    )


def step_outcomes(
    state: CrowdState,
    displacement: np.ndarray,
    agent_velocity: np.ndarray,
    duration: float,
    settings: RewardSettings,
) -> Judgement:
    """
    Judge candidate motions of the robot through the true relative motion over the step.

    An agent is hit when the gap between the rims closes at any moment of the step, a wall when the
    rim is behind it at the end. Clearance does not include the walls; discomfort does where the
    settings say so.

    :param displacement: of the robot, m, (batch, candidates, 2).
    :param agent_velocity: of the agents during the step, m/s, (batch, agents, 2).
    """
    shape, robot, agents = displacement.shape[:2], state.robot, state.agents
    judgement = Judgement(
        np.empty(shape), np.empty(shape, np.int8), np.empty(shape), np.empty(shape)
    )
    scene = Scene(
        robot.position, robot.radius, robot.goal, agents.position, agent_velocity, agents.radius,
        agents.static, agents.valid, state.bounds,
    )  # fmt: skip
    _judge(tuple(scene), displacement, duration, tuple(settings), tuple(judgement))
    return judgement


@compiled
def swept_distance(x, y, move_x, move_y):  # type: ignore[no-untyped-def]
    """Return the least distance from the origin to the segment from (x, y) on by a move, m."""
    approach = -(x * move_x + y * move_y)
    if approach > 0.0:
        # nearest at the foot of the perpendicular, or at the end of the move
        share = min(1.0, approach / (move_x * move_x + move_y * move_y))
        x += share * move_x
        y += share * move_y
    return math.sqrt(x * x + y * y)


# Named tuples come as plain ones: at each call numba asks Python for the type of a named one.
@compiled
def _judge(scene, displacement, duration, settings, judgement):  # type: ignore[no-untyped-def]
    """Fill a Judgement of a Scene by RewardSettings."""
    here, worth, out = Scene(*scene), RewardSettings(*settings), Judgement(*judgement)
    for world in range(displacement.shape[0]):
        robot_x, robot_y = here.robot_position[world, 0], here.robot_position[world, 1]
        robot_radius = here.robot_radius[world]
        for k in range(displacement.shape[1]):
            move_x, move_y = displacement[world, k, 0], displacement[world, k, 1]
            nearest, nearest_pedestrian, hit = math.inf, math.inf, _NONE
            for i in range(here.position.shape[1]):
                if not here.valid[world, i]:
                    continue
                gap = swept_distance(
                    here.position[world, i, 0] - robot_x,
                    here.position[world, i, 1] - robot_y,
                    here.velocity[world, i, 0] * duration - move_x,
                    here.velocity[world, i, 1] * duration - move_y,
                ) - (here.radius[world, i] + robot_radius)
                if gap < nearest:
                    nearest = gap
                    if gap < 0.0:
                        hit = _OBSTACLE if here.static[world, i] else _PEDESTRIAN
                if not here.static[world, i]:
                    nearest_pedestrian = min(nearest_pedestrian, gap)
            x, y = robot_x + move_x, robot_y + move_y
            wall_gap = here.bounds[world] - max(abs(x), abs(y)) - robot_radius
            goal_distance = math.hypot(here.goal[world, 0] - x, here.goal[world, 1] - y)
            comfort_gap = min(nearest, wall_gap) if worth.walls_discomfort else nearest
            missing = comfort_gap - worth.discomfort_distance
            reward, outcome = 0.0, _NONE
            if hit != _NONE:
                reward, outcome = worth.collision, hit
            elif wall_gap < 0.0:
                reward, outcome = worth.out_of_bounds, _OUT
            elif goal_distance < worth.goal_tolerance:
                reward, outcome = worth.goal, _GOAL
            elif missing < 0.0:
                reward = missing * worth.discomfort_factor * duration
            out.reward[world, k], out.outcome[world, k] = reward, outcome
            out.clearance[world, k] = nearest
            out.pedestrian_clearance[world, k] = nearest_pedestrian
