"""The starts of many cases at once, each from its own random streams."""

from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.simulation.layout import Layout, sample_layout


class Starts(NamedTuple):
    """Where the start of each world is written."""

    robot_position: np.ndarray
    """m, (batch, 2)."""
    robot_goal: np.ndarray
    """m, (batch, 2)."""
    position: np.ndarray
    """m, (batch, agents, 2)."""
    radius: np.ndarray
    """m, (batch, agents)."""
    speed: np.ndarray
    """m/s, (batch, agents); obstacles have none."""
    goal: np.ndarray
    """m, (batch, agents, 2)."""
    goal_streams: np.ndarray
    """uint64 (batch, pedestrians, 6)."""


@compiled
def lay_out(worlds, cases, layout_stream, goal_stream, settings, starts):  # type: ignore[no-untyped-def]
    """
    Draw the start of a case in each of some worlds; return the first that failed, or -1.

    :param worlds: indices.
    :param cases: as many case numbers.
    :param layout_stream: stream of the layout of case 0, uint64 (6,).
    :param goal_stream: stream of the goals of pedestrian 0 in case 0, uint64 (6,).
    :param settings: LayoutSettings.
    :param starts: Starts, written.
    """
    robot = np.empty(4)
    for n in range(len(worlds)):
        world = worlds[n]
        draws = layout_stream.copy()
        draws[2] = np.uint64(cases[n])
        layout = Layout(
            robot, starts.position[world], starts.radius[world], starts.speed[world],
            starts.goal[world],
        )  # fmt: skip
        if not sample_layout(draws, settings, layout):
            return n
        starts.robot_position[world] = robot[:2]
        starts.robot_goal[world] = robot[2:]
        for i in range(settings.pedestrians):
            starts.goal_streams[world, i] = goal_stream
            starts.goal_streams[world, i, 2] = np.uint64(cases[n])
            starts.goal_streams[world, i, 4] = np.uint64(i)
    return -1
