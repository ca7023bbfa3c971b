"""Round things among points on surfaces: one circle each."""

import numpy as np

from socialnav_core.sensing.scans import Rays

JOIN_DISTANCE = 0.3
"""Neighbouring points farther apart than this are on different things, m."""
LEAST_POINTS = 5
"""Fewer points make no circle."""
FAR_TOLERANCES = 3
"""Points of a circle lie behind the rim that is seen by so many tolerances at most."""


def circles_of(
    points: np.ndarray, radius_min: float, radius_max: float, tolerance: float
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return centres, m, (circles, 2), and radii, m, (circles,), of the round things seen.

    What is seen is their outside: a niche is no round thing, nor is a room.

    :param points: as seen from the origin, m, (points, 2).
    :param tolerance: root mean square distance of the points from their circle, m.
    """
    groups = [group for group in groups_of(points) if len(group) >= LEAST_POINTS]
    circles = np.array([fitted_circle(group) for group in groups]).reshape(-1, 4)
    behind = [depth_behind(*pair) for pair in zip(groups, circles[:, :2], strict=True)]
    nearest = [np.hypot(group[:, 0], group[:, 1]).min() for group in groups]
    good = np.array(behind) <= FAR_TOLERANCES * tolerance
    # where the nearest part of the rim has not been seen, it may not be there
    rim = np.hypot(circles[:, 0], circles[:, 1]) - circles[:, 2]
    good &= np.abs(rim - np.array(nearest)) <= 2 * tolerance
    good &= (radius_min <= circles[:, 2]) & (circles[:, 2] <= radius_max)
    good &= circles[:, 3] <= tolerance
    return circles[good, :2], circles[good, 2]


def depth_behind(points: np.ndarray, centre: np.ndarray) -> float:
    """
    Return how far the last of some points lies behind the rim that is seen from the origin, m.

    That is how much of its ray lies within the circle: nothing where the near side was hit.

    :param points: on a circle, m, (points, 2).
    :param centre: of the circle, m, (2,).
    """
    distance = np.hypot(points[:, 0], points[:, 1])
    return float((((points - centre) * points).sum(axis=1) / distance).max())


def crossed(centres: np.ndarray, radii: np.ndarray, rays: Rays, tolerance: float) -> np.ndarray:
    """
    Return through which circles a ray goes that ends elsewhere, bool (circles,).

    :param centres: m, (circles, 2).
    :param radii: m, (circles,).
    :param tolerance: so far from the rim a ray may pass or end, m; at most half a radius inside.
    """
    way = rays.ends - rays.origin
    length = np.hypot(way[:, 0], way[:, 1])
    direction = way / np.where(length > 0, length, 1.0)[:, None]
    to_centre = centres[:, None] - rays.origin  # (circles, 1, 2)
    along = np.clip((to_centre * direction).sum(axis=-1), 0.0, length)  # (circles, rays)
    missed = np.hypot(*np.moveaxis(to_centre - along[..., None] * direction, -1, 0))
    from_end = np.hypot(*np.moveaxis(centres[:, None] - rays.ends, -1, 0))
    behind = ((rays.ends - centres[:, None]) * direction).sum(axis=-1)
    elsewhere = np.abs(from_end - radii[:, None]) > tolerance
    elsewhere |= behind > FAR_TOLERANCES / 2 * tolerance  # it ends at the far side
    inside = missed < radii[:, None] - np.minimum(tolerance, radii[:, None] / 2)
    return (inside & elsewhere).any(axis=1)


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
