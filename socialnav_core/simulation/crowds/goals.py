"""Where people want to go."""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.layout import ATTEMPTS, GAP, near_any, PackingError
from socialnav_core.simulation.random_streams import uniform


def velocities_to_goals(
    episodes: Episodes, rows: int, speed: np.ndarray | None = None
) -> np.ndarray:
    """
    Return how people would walk if they were alone, m/s, (batch, rows, 2).

    They walk at full speed, slower within the last metre.

    :param rows: at least the number of pedestrians; what lies behind them is not set.
    :param speed: m/s, (batch, agents); None for what each prefers.
    """
    speed = episodes.preferred_speed if speed is None else speed
    position, goal = episodes.state.agents.position, episodes.goal
    out = np.empty((len(goal), rows, 2))
    _head_for_goals(position, goal, speed, episodes.scenario.pedestrians, out)
    return out


@compiled
def _head_for_goals(position, goal, speed, movers, out):  # type: ignore[no-untyped-def]
    """Fill the array of velocities_to_goals for the first `movers` agents."""
    for world in range(position.shape[0]):
        for i in range(movers):
            x = goal[world, i, 0] - position[world, i, 0]
            y = goal[world, i, 1] - position[world, i, 1]
            scale = speed[world, i] / max(1.0, math.sqrt(x * x + y * y))
            out[world, i, 0], out[world, i, 1] = x * scale, y * scale


def renew_goals(episodes: Episodes) -> None:
    """
    Give another goal, on a circle, to every pedestrian within its radius of its goal.

    :raises PackingError: when obstacles cover the whole circle of goals.
    """
    agents, scenario = episodes.state.agents, episodes.scenario
    if not _renew_arrived(
        episodes.goal_streams, scenario.spawn_half_width, episodes.active, agents.position,
        agents.radius, episodes.goal,
    ):  # fmt: skip
        raise PackingError(
            f'scenario {scenario.name}: obstacles cover the circle of goals, of radius '
            f'{scenario.spawn_half_width:g} m; lower obstacles or obstacle_radius_max'
        )


@compiled
def _renew_arrived(streams, half_width, active, position, radius, goal):  # type: ignore[no-untyped-def]
    """
    Renew the goals of pedestrians that arrived; return whether each found one.

    :param streams: random streams, uint64 (batch, pedestrians, 6), advanced.
    :param half_width: radius of the circle of goals, m.
    :param active: worlds that run, bool (batch,).
    """
    for world in range(streams.shape[0]):
        if not active[world]:
            continue
        for i in range(streams.shape[1]):
            x = goal[world, i, 0] - position[world, i, 0]
            y = goal[world, i, 1] - position[world, i, 1]
            if x * x + y * y >= radius[world, i] ** 2:
                continue
            if not _draw_goal(streams, half_width, world, i, position, radius, goal):
                return False
    return True


@compiled
def _draw_goal(streams, half_width, world, i, position, radius, goal):  # type: ignore[no-untyped-def]
    """Draw a goal for a pedestrian, free of obstacles; return whether one was found."""
    pedestrians, agents = streams.shape[1], position.shape[1]
    gap = radius[world, i] + GAP
    for _ in range(ATTEMPTS):
        angle = uniform(streams[world, i], 0.0, 2.0 * math.pi)
        x, y = half_width * math.cos(angle), half_width * math.sin(angle)
        if not near_any(x, y, gap, position[world], radius[world], pedestrians, agents):
            goal[world, i, 0], goal[world, i, 1] = x, y
            return True
    return False
