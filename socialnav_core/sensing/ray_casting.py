"""How far a ray goes among discs and walls."""

import numpy as np

WALL, NOTHING = -1, -2
"""What a ray hits where it is no disc."""


def beam_angles(beams: int) -> np.ndarray:
    """Return the directions of the beams of a scanner that sees all around, rad, (beams,)."""
    return 2 * np.pi * np.arange(beams) / beams - np.pi


def cast_rays(
    origin: np.ndarray,
    angles: np.ndarray,
    position: np.ndarray,
    radius: np.ndarray,
    bounds: float = np.inf,
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return how far rays go, m, inf where nothing is hit, (rays,), and what they hit, (rays,).

    What is hit is the index of a disc, WALL or NOTHING. A ray from within a disc has length 0.

    :param origin: of all rays, m, (2,).
    :param angles: directions, rad, (rays,).
    :param position: centres of the discs, m, (discs, 2).
    :param radius: of the discs, m, (discs,).
    :param bounds: half-width of the square of walls around the world's origin, m, inf for none.
    """
    direction = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    to_discs = disc_distances(position - origin, radius, direction)
    to_wall = wall_distances(origin, direction, bounds)
    distances = np.concatenate([to_discs, to_wall[:, None]], axis=1)
    nearest = distances.argmin(axis=1)
    length = distances[np.arange(len(angles)), nearest]
    hit = np.where(nearest == len(radius), WALL, nearest)
    return length, np.where(np.isinf(length), NOTHING, hit)


def disc_distances(offset: np.ndarray, radius: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """
    Return how far each ray goes until each disc, m, inf where it misses, (rays, discs).

    :param offset: of the centres from the origin of the rays, m, (discs, 2).
    :param radius: of the discs, m, (discs,).
    :param direction: unit vectors, (rays, 2).
    """
    along = direction @ offset.T
    across = direction[:, :1] * offset[:, 1] - direction[:, 1:] * offset[:, 0]
    # a ray that passes the disc by has no chord: the clamp only keeps the root real
    half_chord = np.sqrt(np.maximum(radius**2 - across**2, 0.0))
    # beside the disc, or all of it behind the origin
    missed = (np.abs(across) > radius) | (along + half_chord < 0)
    # from within a disc the way into it is negative
    return np.where(missed, np.inf, np.maximum(along - half_chord, 0.0))


def wall_distances(origin: np.ndarray, direction: np.ndarray, bounds: float) -> np.ndarray:
    """
    Return how far each ray goes until it leaves the square, m, inf without walls, (rays,).

    :param origin: of all rays, m, (2,).
    :param direction: unit vectors, (rays, 2).
    :param bounds: half-width of the square, m.
    """
    if np.isinf(bounds):
        return np.full(len(direction), np.inf)
    with np.errstate(divide='ignore', invalid='ignore'):
        # along each axis only the wall ahead can be reached
        lengths = (bounds * np.sign(direction) - origin) / direction
    return np.maximum(np.where(direction == 0, np.inf, lengths).min(axis=1), 0.0)
