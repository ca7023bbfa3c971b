"""Screening of actions: after a safe one there is a way out (cf. Fiorini and Shiller 1998)."""

from collections.abc import Iterator
import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import ScreeningConfig
from socialnav_core.simulation.kinematics import Kinematics, Limits
from socialnav_core.simulation.rewards import swept_distance
from socialnav_core.states import CrowdState

STANDING_SPEED = 0.1  # pedestrians slower than this, m/s, may start walking in any direction


def safe_actions(
    state: CrowdState,
    commands: np.ndarray,
    agent_velocity: np.ndarray,
    kinematics: Kinematics,
    time_step: float,
    config: ScreeningConfig,
    deviation: np.ndarray,
    limits: Limits | None = None,
    wanted: np.ndarray | None = None,
) -> np.ndarray:
    """
    Return which actions are safe, bool (batch, actions).

    An action is safe when it is free of collisions itself and when, after it, one of the same
    actions stays so for the horizon, everybody else keeping to the predicted velocity. Where no
    action is safe, those free of collisions themselves are returned; where there is none of these
    either, all are. A robot of limited acceleration escapes by changing from the action towards
    one of the wanted commands.

    :param commands: candidate commands, (batch, actions, 2).
    :param agent_velocity: predicted velocities, m/s, (batch, agents, 2).
    :param time_step: how long an action lasts, s.
    :param deviation: standard deviation of the predicted positions, m, (batch, agents); where it
        is zero, pedestrians need no margin of their own.
    :param wanted: commands to escape towards where acceleration is limited, (batch, actions, 2);
        the candidates where it is None.
    """
    batch, actions = commands.shape[:2]
    ramp = None if limits is None or math.isinf(limits.acceleration) else limits
    gaps = distances_to_keep(state, agent_velocity, config, deviation)
    displacement, _, heading = kinematics.move(state.robot.heading[:, None], commands, time_step)
    start = np.broadcast_to(state.robot.position[:, None], displacement.shape)
    first = is_free(
        state, start, displacement, state.agents.position, agent_velocity, time_step, gaps
    )

    # every escape action after every action, (batch, actions * actions, ...)
    position = state.agents.position + agent_velocity * time_step
    start = np.repeat(start + displacement, actions, axis=1)
    heading = np.repeat(np.broadcast_to(heading, (batch, actions)), actions, axis=1)
    present = np.repeat(commands, actions, axis=1)
    escapes = np.tile(commands if ramp is None or wanted is None else wanted, (1, actions, 1))
    # a straight line is checked in one piece, an arc in pieces that are nearly straight
    straight = kinematics.straight and ramp is None
    pieces = 1 if straight else max(1, round(config.horizon / time_step))
    duration = config.horizon / pieces
    free = np.ones((batch, actions * actions), bool)
    for displacement in motions(kinematics, heading, present, escapes, ramp, duration, pieces):
        free &= is_free(state, start, displacement, position, agent_velocity, duration, gaps)
        start, position = start + displacement, position + agent_velocity * duration
    escapable = first & free.reshape(batch, actions, actions).any(axis=-1)
    fallback = np.where(first.any(axis=1, keepdims=True), first, True)
    return np.where(escapable.any(axis=1, keepdims=True), escapable, fallback)


def motions(
    kinematics: Kinematics,
    heading: np.ndarray,
    present: np.ndarray,
    commands: np.ndarray,
    limits: Limits | None,
    duration: float,
    pieces: int,
) -> Iterator[np.ndarray]:
    """
    Yield how far robots move in each piece of time, m, (batch, motions, 2).

    :param heading: at the beginning, rad, (batch, motions).
    :param present: commands at the beginning, (batch, motions, 2).
    :param commands: what they change to, (batch, motions, 2).
    :param limits: how fast that goes; None for at once.
    :param duration: of a piece, s.
    """
    for _ in range(pieces):
        motion = commands
        if limits is not None:
            following = kinematics.reachable(commands, present, limits, duration)
            motion = kinematics.mean_command(present, following)
            present = following
        displacement, _, heading = kinematics.move(heading, motion, duration)
        yield displacement


def distances_to_keep(
    state: CrowdState, agent_velocity: np.ndarray, config: ScreeningConfig, deviation: np.ndarray
) -> np.ndarray:
    """
    Return the distance of centres to keep from each agent, m, (batch, agents).

    A pedestrian who is within its margin already must not come nearer, but may go away.

    :param agent_velocity: predicted velocities, m/s, (batch, agents, 2).
    :param deviation: of the predicted positions, m, (batch, agents).
    """
    least = state.robot.radius[:, None] + state.agents.radius + config.margin
    standing = np.hypot(agent_velocity[..., 0], agent_velocity[..., 1]) < STANDING_SPEED
    margin = np.where(standing, config.standing_margin, config.moving_margin)
    wanted = least - config.margin + np.where(state.agents.static, config.margin, margin)
    distance = np.linalg.norm(state.agents.position - state.robot.position[:, None], axis=-1)
    kept = np.maximum(least, np.minimum(wanted, distance))
    return np.where(deviation > 0.0, kept, least)


def is_free(
    state: CrowdState,
    start: np.ndarray,
    displacement: np.ndarray,
    position: np.ndarray,
    agent_velocity: np.ndarray,
    duration: float,
    gaps: np.ndarray,
) -> np.ndarray:
    """
    Return whether straight motions of the robot touch nobody and no wall, bool (batch, motions).

    :param start: of the motions, m, (batch, motions, 2).
    :param displacement: m, (batch, motions, 2).
    :param position: of the agents at the start, m, (batch, agents, 2).
    :param agent_velocity: m/s, (batch, agents, 2).
    :param gaps: distance of centres to keep from each agent, m, (batch, agents).
    """
    free = np.empty(displacement.shape[:2], bool)
    limit = state.bounds - state.robot.radius
    _check(
        start,
        displacement,
        position,
        agent_velocity * duration,
        gaps,
        state.agents.valid,
        limit,
        free,
    )
    return free


@compiled
def _check(start, displacement, position, movement, gaps, valid, limit, free):  # type: ignore[no-untyped-def]
    """Fill the array of is_free."""
    for world in range(free.shape[0]):
        for k in range(free.shape[1]):
            x, y = start[world, k, 0], start[world, k, 1]
            move_x, move_y = displacement[world, k, 0], displacement[world, k, 1]
            free[world, k] = max(abs(x + move_x), abs(y + move_y)) <= limit[world]
            for i in range(position.shape[1]):
                if not free[world, k]:
                    break
                if valid[world, i]:
                    free[world, k] = gaps[world, i] <= swept_distance(
                        position[world, i, 0] - x,
                        position[world, i, 1] - y,
                        movement[world, i, 0] - move_x,
                        movement[world, i, 1] - move_y,
                    )
