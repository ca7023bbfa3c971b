"""Many points around a robot, thinned out: the nearest in each direction stands for the others."""

import numpy as np

SECTORS = 36
"""Number of directions that are told apart."""
MAX_RANGE = 6.0
"""Points farther away are not looked at, m."""
LEAST_RADIUS = 0.1
"""Radius of the disc that stands for a point, m, unless the point is a larger cell."""


def nearest_of_sectors(
    points: np.ndarray, sectors: int = SECTORS, max_range: float = MAX_RANGE
) -> np.ndarray:
    """
    Return the indices of the nearest point in each direction where there is one, ascending.

    :param points: relative to the robot, m, (points, 2).
    :param sectors: number of equal sectors; the first begins at the x axis.
    :param max_range: points beyond do not count, m.
    """
    distance = np.hypot(points[:, 0], points[:, 1])
    angle = np.arctan2(points[:, 1], points[:, 0]) % (2 * np.pi)
    sector = np.minimum((angle * (sectors / (2 * np.pi))).astype(int), sectors - 1)
    order = np.lexsort((distance, sector))
    order = order[distance[order] <= max_range]
    _, first = np.unique(sector[order], return_index=True)
    return np.sort(order[first])
