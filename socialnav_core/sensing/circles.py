"""Round things among points on surfaces: one circle each."""

import numpy as np

JOIN_DISTANCE = 0.3
"""Neighbouring points farther apart than this are on different things, m."""
LEAST_POINTS = 5
"""Fewer points make no circle."""


def circles_of(
    points: np.ndarray, radius_min: float, radius_max: float, tolerance: float
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return centres, m, (circles, 2), and radii, m, (circles,), of the round things seen.

    :param points: as seen from the origin, m, (points, 2).
    :param tolerance: root mean square distance of the points from their circle, m.
    """
    found = [fitted_circle(group) for group in groups_of(points) if len(group) >= LEAST_POINTS]
    circles = np.array(found).reshape(-1, 4)
    good = (radius_min <= circles[:, 2]) & (circles[:, 2] <= radius_max)
    good &= circles[:, 3] <= tolerance
    return circles[good, :2], circles[good, 2]


def groups_of(points: np.ndarray) -> list[np.ndarray]:
    """
    Return points in groups, in the order of directions, cut where neighbours are far apart.

    :param points: as seen from the origin, m, (points, 2).
    """
    if not len(points):
        return []
    points = points[np.argsort(np.arctan2(points[:, 1], points[:, 0]))]
    step = points - np.roll(points, 1, axis=0)  # the last one comes before the first
    cuts = np.flatnonzero(np.hypot(step[:, 0], step[:, 1]) > JOIN_DISTANCE)
    if not len(cuts):
        return [points]
    return np.split(np.roll(points, -cuts[0], axis=0), cuts[1:] - cuts[0])


def fitted_circle(points: np.ndarray) -> tuple[float, float, float, float]:
    """
    Return x, y and radius of a circle through points, m, (points, 2), and how far off they are, m.

    The circle is that of Kasa (1976); the distance is the root of the mean square.
    """
    middle = points.mean(axis=0)
    offset = points - middle
    # linear in x, y and rest = r^2 - x^2 - y^2: u^2 + v^2 = 2 u x + 2 v y + rest
    system = np.column_stack([2 * offset, np.ones(len(offset))])
    x, y, rest = np.linalg.lstsq(system, (offset**2).sum(axis=1), rcond=None)[0]
    radius = np.sqrt(max(rest + x * x + y * y, 0.0))
    distance = np.hypot(offset[:, 0] - x, offset[:, 1] - y) - radius
    return middle[0] + x, middle[1] + y, radius, np.sqrt(np.mean(distance**2))
