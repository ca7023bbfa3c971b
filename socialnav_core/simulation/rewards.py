"""What a step of the robot leads to and what it is worth."""

import enum
import math
from typing import Any

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


def reward_settings(reward: RewardConfig, goal_tolerance: float) -> tuple[Any, ...]:
    """
    Return the settings that the compiled functions take.

    :param reward: worth of each term.
    :param goal_tolerance: distance at which the goal is reached, m.
    """
    return (
        reward.goal, reward.collision, reward.out_of_bounds, reward.discomfort_distance,
        reward.discomfort_factor, reward.walls_discomfort, goal_tolerance,
    )  # fmt: skip


def step_outcomes(
    state: CrowdState,
    displacement: np.ndarray,
    agent_velocity: np.ndarray,
    duration: float,
    settings: tuple[Any, ...],
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """
    Judge candidate motions of the robot through the true relative motion over the step.

    Return rewards float64, outcomes int8 (never TIMEOUT), clearances and clearances to
    pedestrians alone, m, inf where there is nobody; all (batch, candidates). An agent is hit when
    the gap between the rims closes at any moment of the step, a wall when the rim is behind it at
    the end. Clearance does not include the walls; discomfort does where the settings say so.

    :param state: the world before the step.
    :param displacement: of the robot, m, (batch, candidates, 2).
    :param agent_velocity: of the agents during the step, m/s, (batch, agents, 2).
    :param duration: s.
    :param settings: of reward_settings.
    """
    shape, robot, agents = displacement.shape[:2], state.robot, state.agents
    reward, outcome = np.empty(shape), np.empty(shape, np.int8)
    clearance, pedestrian_clearance = np.empty(shape), np.empty(shape)
    _judge(
        robot.position, robot.radius, robot.goal, displacement, agents.position, agent_velocity,
        agents.radius, agents.static, agents.valid, state.bounds, duration, settings,
        reward, outcome, clearance, pedestrian_clearance,
    )  # fmt: skip
    return reward, outcome, clearance, pedestrian_clearance


@compiled
def swept_distance(x, y, move_x, move_y):  # type: ignore[no-untyped-def]
    """
    Return the least distance from the origin to the segment from p to p + move.

    :param x: start, m.
    :param y: start, m.
    :param move_x: m.
    :param move_y: m.
    """
    approach = -(x * move_x + y * move_y)
    if approach > 0.0:
        share = min(1.0, approach / (move_x * move_x + move_y * move_y))
        x += share * move_x
        y += share * move_y
    return math.sqrt(x * x + y * y)


@compiled
def _judge(  # type: ignore[no-untyped-def]
    robot, robot_radius, goal, displacement, position, velocity, radius, static, valid, bounds,
    duration, settings, reward, outcome, clearance, pedestrian_clearance,
):  # fmt: skip
    """Fill the four arrays of step_outcomes."""
    goal_reward, hit_reward, out_reward, comfort, factor, walls, tolerance = settings
    for world in range(displacement.shape[0]):
        for k in range(displacement.shape[1]):
            move_x, move_y = displacement[world, k, 0], displacement[world, k, 1]
            nearest, nearest_pedestrian, hit = math.inf, math.inf, _NONE
            for i in range(position.shape[1]):
                if not valid[world, i]:
                    continue
                gap = swept_distance(
                    position[world, i, 0] - robot[world, 0],
                    position[world, i, 1] - robot[world, 1],
                    velocity[world, i, 0] * duration - move_x,
                    velocity[world, i, 1] * duration - move_y,
                ) - (radius[world, i] + robot_radius[world])
                if gap < nearest:
                    nearest = gap
                    if gap < 0.0:
                        hit = _OBSTACLE if static[world, i] else _PEDESTRIAN
                if not static[world, i]:
                    nearest_pedestrian = min(nearest_pedestrian, gap)
            x, y = robot[world, 0] + move_x, robot[world, 1] + move_y
            wall_gap = bounds[world] - max(abs(x), abs(y)) - robot_radius[world]
            goal_distance = math.hypot(goal[world, 0] - x, goal[world, 1] - y)
            comfort_gap = min(nearest, wall_gap) if walls else nearest
            clearance[world, k] = nearest
            pedestrian_clearance[world, k] = nearest_pedestrian
            if hit != _NONE:
                reward[world, k], outcome[world, k] = hit_reward, hit
            elif wall_gap < 0.0:
                reward[world, k], outcome[world, k] = out_reward, _OUT
            elif goal_distance < tolerance:
                reward[world, k], outcome[world, k] = goal_reward, _GOAL
            elif comfort_gap < comfort:
                reward[world, k] = (comfort_gap - comfort) * factor * duration
                outcome[world, k] = _NONE
            else:
                reward[world, k], outcome[world, k] = 0.0, _NONE
