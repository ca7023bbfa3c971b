"""What pedestrians decide: where to go next, and how fast without bumping into others."""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.orca import orca_step
from socialnav_core.simulation.layout import PackingError, renew_goal

RADIUS_PADDING = 0.01  # RVO2's users inflate every disc by it, lest touching ones collide
RECIPROCAL = 0.5


def decide_velocities(
    scenario: Scenario, episodes: Episodes, due: np.ndarray, decided: np.ndarray
) -> np.ndarray:
    """
    Return the velocities of all agents, chosen anew by ORCA in some worlds, (batch, agents, 2).

    :param scenario: settings of ORCA; who is seen.
    :param episodes: the worlds and the pedestrians' goals.
    :param due: worlds to decide in, bool (batch,).
    :param decided: velocities so far, m/s, (batch, agents, 2), zero for obstacles; may be changed.
    """
    agents, orca, speed = episodes.state.agents, scenario.orca, episodes.preferred_speed
    if scenario.robot_visible:  # the robot is one more body, behind the others
        robot = episodes.state.robot
        agents = agents.append(robot.as_agents())
        speed = np.concatenate([speed, robot.preferred_speed[:, None]], axis=1)
        decided = np.concatenate([decided, robot.velocity[:, None]], axis=1)
    preferred = np.empty_like(agents.position)
    head_for_goals(agents.position, episodes.goal, speed, scenario.pedestrians, preferred)
    orca_step(
        agents.position, agents.velocity, preferred,
        agents.radius + (RADIUS_PADDING + orca.safety_space), speed, agents.valid,
        np.where(agents.static, orca.static_responsibility, RECIPROCAL),
        np.full_like(agents.radius, orca.neighbor_distance), due, scenario.pedestrians,
        orca.max_neighbors, orca.time_horizon, scenario.time_step, decided,
    )  # fmt: skip
    return np.ascontiguousarray(decided[:, : scenario.agents])


@compiled
def head_for_goals(position, goal, speed, movers, out):  # type: ignore[no-untyped-def]
    """
    Write the preferred velocities: at full speed to the goal, slower within the last metre.

    :param position: m, (batch, agents, 2).
    :param goal: m, (batch, agents, 2).
    :param speed: m/s, (batch, agents).
    :param movers: number of agents that want to move.
    :param out: m/s, (batch, agents, 2).
    """
    for world in range(position.shape[0]):
        for i in range(movers):
            x = goal[world, i, 0] - position[world, i, 0]
            y = goal[world, i, 1] - position[world, i, 1]
            scale = speed[world, i] / max(1.0, math.sqrt(x * x + y * y))
            out[world, i, 0], out[world, i, 1] = x * scale, y * scale


def renew_goals(scenario: Scenario, episodes: Episodes) -> None:
    """
    Give another goal to every pedestrian within its radius of its goal.

    :param scenario: circle of goals.
    :param episodes: the worlds and the pedestrians' goals, changed in place.
    :raises PackingError: when obstacles cover the whole circle of goals.
    """
    state = episodes.state
    if not renew_arrived_goals(
        episodes.goal_streams, scenario.spawn_half_width, episodes.active, state.agents.position,
        state.agents.radius, episodes.goal,
    ):  # fmt: skip
        raise PackingError(
            f'scenario {scenario.name}: obstacles cover the circle of goals, of radius '
            f'{scenario.spawn_half_width:g} m; lower obstacles or obstacle_radius_max'
        )


@compiled
def renew_arrived_goals(streams, half_width, active, position, radius, goal):  # type: ignore[no-untyped-def]
    """
    Renew the goals of pedestrians that arrived; return whether each found one.

    :param streams: random streams, uint64 (batch, pedestrians, 6), advanced.
    :param half_width: radius of the circle of goals, m.
    :param active: worlds that run, bool (batch,).
    :param position: m, (batch, agents, 2).
    :param radius: m, (batch, agents).
    :param goal: m, (batch, agents, 2), changed.
    """
    pedestrians = streams.shape[1]
    for world in range(streams.shape[0]):
        if not active[world]:
            continue
        for i in range(pedestrians):
            x = goal[world, i, 0] - position[world, i, 0]
            y = goal[world, i, 1] - position[world, i, 1]
            if x * x + y * y >= radius[world, i] ** 2:
                continue
            if not renew_goal(streams[world, i], half_width, i, pedestrians, position[world],
                              radius[world], goal[world]):  # fmt: skip
                return False
    return True
