"""
Optimal reciprocal collision avoidance (ORCA) for a batch of worlds.

Source: J. van den Berg, S. J. Guy, M. Lin and D. Manocha, Reciprocal n-body collision avoidance,
Robotics Research (ISRR 2009), Springer 2011.
"""

from typing import Any

import numpy as np

from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step


def orca_velocities(
    position: np.ndarray,
    velocity: np.ndarray,
    preferred_velocity: np.ndarray,
    radius: np.ndarray,
    max_speed: np.ndarray,
    valid: np.ndarray | None = None,
    responsibility: float | np.ndarray = 0.5,
    neighbor_distance: float | np.ndarray = 10.0,
    max_neighbors: int = 10,
    time_horizon: float = 5.0,
    time_step: float = 0.25,
) -> np.ndarray:
    """
    Return the velocity of each agent that avoids its neighbours and is nearest its preferred one.

    Discs avoid each other for `time_horizon` seconds if all of them keep to these velocities. In
    a crowd where nobody can, each agent takes the velocity that violates its constraints least.

    :param position: Centres, metres, shape (batch, agents, 2).
    :param velocity: Present velocities, m/s, shape (batch, agents, 2).
    :param preferred_velocity: Velocities without neighbours, m/s, shape (batch, agents, 2).
    :param radius: Radii as they are to be kept apart, metres: a number or (batch, agents).
    :param max_speed: Greatest speeds, m/s: a number or (batch, agents).
    :param valid: Mask of real agents, shape (batch, agents); None means all. An invalid agent
        influences nobody and its velocity is zero.
    :param responsibility: Share of a conflict with this agent that each other agent takes: 0.5
        where it does its half, 1.0 where it does not step aside. A number or (batch, agents).
    :param neighbor_distance: Distance of centres, metres, from which an agent does not notice
        others: a number or (batch, agents).
    :param max_neighbors: Number of nearest neighbours, by centre distance, that an agent notices.
    :param time_horizon: Seconds for which velocities are free of collisions.
    :param time_step: Seconds within which discs that overlap already move apart.
    :return: New array of velocities, m/s, float64, shape (batch, agents, 2).
    :raises ValueError: Where shapes disagree, a valid agent's value is not finite, a radius,
        speed, distance or number is negative, or a time is not positive.
    """
    shape = np.shape(position)
    if len(shape) != 3 or shape[2] != 2:
        raise ValueError(f'position has shape {shape}, expected (batch, agents, 2)')
    mask = np.ones(shape[:2], bool) if valid is None else np.ascontiguousarray(valid, dtype=bool)
    if mask.shape != shape[:2]:
        raise ValueError(f'valid has shape {mask.shape}, expected {shape[:2]}')
    if not (time_horizon > 0.0 and time_step > 0.0 and max_neighbors >= 0):
        raise ValueError('time_horizon and time_step must be positive, max_neighbors at least 0')
    out = np.empty(shape)
    bodies = Bodies(
        _vectors('position', position, mask),
        _vectors('velocity', velocity, mask),
        _vectors('preferred_velocity', preferred_velocity, mask),
        _sizes('radius', radius, mask),
        _sizes('max_speed', max_speed, mask),
        mask,
        _sizes('responsibility', responsibility, mask),
        _sizes('neighbor_distance', neighbor_distance, mask),
    )
    foresight = Foresight(max_neighbors, time_horizon, time_step)
    orca_step(bodies, foresight, np.ones(shape[0], bool), shape[1], out)
    return out


def _vectors(name: str, value: Any, valid: np.ndarray) -> np.ndarray:
    """Return an argument as contiguous float64, shape (batch, agents, 2)."""
    array = np.ascontiguousarray(value, dtype=np.float64)
    if array.shape != (*valid.shape, 2):
        raise ValueError(f'{name} has shape {array.shape}, expected {(*valid.shape, 2)}')
    if not np.isfinite(array[valid]).all():
        raise ValueError(f'{name} of a valid agent is not finite: mark padding in valid')
    return array


def _sizes(name: str, value: Any, valid: np.ndarray) -> np.ndarray:
    """Return an argument as contiguous float64, shape (batch, agents); a number fills it."""
    array = np.asarray(value, dtype=np.float64)
    if array.shape not in ((), valid.shape):
        raise ValueError(f'{name} has shape {array.shape}, expected a number or {valid.shape}')
    array = np.ascontiguousarray(np.broadcast_to(array, valid.shape))
    if not ((array[valid] >= 0.0) & (array[valid] < np.inf)).all():
        raise ValueError(f'{name} of a valid agent is negative or not finite')
    return array
