"""The end of a step: everybody moves, and the episode's records grow."""

import math

from socialnav_core.compilation import compiled
from socialnav_core.simulation.rewards import Outcome

TIME_TOLERANCE = 1e-9  # sums of time steps are not exact

_NONE, _TIMEOUT = int(Outcome.NONE), int(Outcome.TIMEOUT)


@compiled
def move_worlds(  # type: ignore[no-untyped-def]
    active, displacement, robot_velocity, heading, agent_velocity, duration, clearance, time_limit,
    state, until_decision, records, reward, outcome,
):  # fmt: skip
    """
    Move everybody in the active worlds, in place; where time is up and nothing else, end them.

    :param active: worlds that run, bool (batch,); the others earn nothing and end no more.
    :param displacement: of the robots, m, (batch, 2).
    :param robot_velocity: m/s, (batch, 2).
    :param heading: of the robots, rad, (batch,).
    :param agent_velocity: m/s, (batch, agents, 2).
    :param duration: s.
    :param clearance: least gap in this step, m, (batch,).
    :param time_limit: s.
    :param state: robot_position, robot_velocity, robot_heading, position, velocity and time.
    :param until_decision: time until pedestrians decide again, s, (batch,).
    :param records: steps, path_length and minimum_clearance, (batch,) each.
    :param reward: (batch,).
    :param outcome: codes of Outcome, (batch,).
    """
    robot_position, present_velocity, robot_heading, position, velocity, time = state
    steps, path_length, minimum_clearance = records
    for world in range(active.shape[0]):
        if not active[world]:
            reward[world], outcome[world] = 0.0, _NONE
            continue
        x, y = displacement[world, 0], displacement[world, 1]
        robot_position[world, 0] += x
        robot_position[world, 1] += y
        present_velocity[world, 0] = robot_velocity[world, 0]
        present_velocity[world, 1] = robot_velocity[world, 1]
        robot_heading[world] = heading[world]
        for i in range(position.shape[1]):
            for axis in range(2):
                velocity[world, i, axis] = agent_velocity[world, i, axis]
                position[world, i, axis] += agent_velocity[world, i, axis] * duration
        time[world] += duration
        until_decision[world] -= duration
        steps[world] += 1
        path_length[world] += math.sqrt(x * x + y * y)
        minimum_clearance[world] = min(minimum_clearance[world], clearance[world])
        if outcome[world] == _NONE and time[world] >= time_limit - TIME_TOLERANCE:
            outcome[world] = _TIMEOUT
