"""The end of a step: everybody moves, and the episode's records grow."""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.simulation.rewards import Outcome

TIME_TOLERANCE = 1e-9  # sums of time steps are not exact

_NONE, _TIMEOUT = int(Outcome.NONE), int(Outcome.TIMEOUT)


class Motion(NamedTuple):
    """What everybody does in a step."""

    displacement: np.ndarray
    """Of the robots, m, (batch, 2)."""
    robot_velocity: np.ndarray
    """At the end of the step, m/s, (batch, 2)."""
    heading: np.ndarray
    """Of the robots at the end, rad, (batch,)."""
    robot_turn_rate: np.ndarray
    """rad/s, (batch,)."""
    agent_velocity: np.ndarray
    """m/s, (batch, agents, 2)."""


class Moving(NamedTuple):
    """What a step changes of a CrowdState, and the time until the crowd decides again."""

    robot_position: np.ndarray
    robot_velocity: np.ndarray
    robot_heading: np.ndarray
    robot_turn_rate: np.ndarray
    position: np.ndarray
    velocity: np.ndarray
    time: np.ndarray
    until_decision: np.ndarray
    """s, (batch,)."""


class Records(NamedTuple):
    """What a step adds to of an episode, (batch,) each."""

    steps: np.ndarray
    path_length: np.ndarray
    minimum_clearance: np.ndarray


# Named tuples come as plain ones: at each call numba asks Python for the type of a named one.
@compiled
def move_worlds(  # type: ignore[no-untyped-def]
    active, motion, duration, clearance, time_limit, moving, records, reward, outcome
):
    """
    Move everybody in the active worlds, in place; where time is up and nothing else, end them.

    :param active: worlds that run, bool (batch,); the others earn nothing and end no more.
    :param motion: a Motion.
    :param clearance: least gap in this step, m, (batch,).
    :param moving: a Moving, changed.
    :param records: Records, changed.
    :param reward: changed, (batch,).
    :param outcome: codes of Outcome, changed, (batch,).
    """
    does, now, record = Motion(*motion), Moving(*moving), Records(*records)
    for world in range(active.shape[0]):
        if not active[world]:
            reward[world], outcome[world] = 0.0, _NONE
            continue
        x, y = does.displacement[world, 0], does.displacement[world, 1]
        now.robot_position[world, 0] += x
        now.robot_position[world, 1] += y
        now.robot_velocity[world, 0] = does.robot_velocity[world, 0]
        now.robot_velocity[world, 1] = does.robot_velocity[world, 1]
        now.robot_heading[world] = does.heading[world]
        now.robot_turn_rate[world] = does.robot_turn_rate[world]
        for i in range(now.position.shape[1]):
            for axis in range(2):
                now.velocity[world, i, axis] = does.agent_velocity[world, i, axis]
                now.position[world, i, axis] += does.agent_velocity[world, i, axis] * duration
        now.time[world] += duration
        now.until_decision[world] -= duration
        record.steps[world] += 1
        record.path_length[world] += math.sqrt(x * x + y * y)
        record.minimum_clearance[world] = min(record.minimum_clearance[world], clearance[world])
        if outcome[world] == _NONE and now.time[world] >= time_limit - TIME_TOLERANCE:
            outcome[world] = _TIMEOUT
