"""From points on surfaces to the few discs that matter to a robot."""

import dataclasses
from typing import Annotated

import numpy as np

from socialnav_core.config.ranges import Range, require_allowed
from socialnav_core.sensing.circles import circles_of, crossed
from socialnav_core.sensing.scans import Rays

VISIBLE_SECTORS = 720
"""Within so small a sector only the nearest point is on what the robot sees."""
RIM_TOLERANCES = 2
"""Points so many tolerances outside of a circle are still on it."""


@dataclasses.dataclass(frozen=True)
class SurfaceSettings:
    """How discs are made of points."""

    sectors: Annotated[int, Range(1, 3600)] = 18
    """Number of equal sectors around the robot, at most one disc in each."""
    disc_radius: Annotated[float, Range(0.001, 10)] = 0.3
    """Radius of these discs, m."""
    max_range: Annotated[float, Range(0.01, 1000)] = 6.0
    """Points farther away than this are dropped, m."""
    smallest_circle: Annotated[float, Range(0.001, 100)] = 0.05
    """Surfaces on a circle of at least this radius become one disc, m."""
    largest_circle: Annotated[float, Range(0, 100)] = 2.0
    """Surfaces on a circle up to this radius become one disc, m; 0: none do."""
    circle_tolerance: Annotated[float, Range(0, 1)] = 0.04
    """Root mean square distance of the points from such a circle, m."""
    bounds: Annotated[float, Range(0.01, 1e6, or_infinite=True)] = np.inf
    """Half-width of the square around the world's origin; points outside are dropped, m."""
    people_margin: Annotated[float, Range(0, 10)] = 0.2
    """Points no farther from a known person's rim than this belong to that person, m."""
    footprint: Annotated[float, Range(0, 10)] = 0.0
    """Points nearer to the robot's centre than this are the robot itself, m."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


def grid_returns(levels: np.ndarray, resolution: float, threshold: int) -> np.ndarray:
    """
    Return the centres of the occupied cells, in the frame of the grid's corner, m, (cells, 2).

    :param levels: 0 to 100, -1 where nothing is known, (rows, columns), rows along y.
    :param resolution: side of a cell, m.
    :param threshold: smallest level that is occupied.
    """
    rows, columns = np.nonzero(levels >= threshold)
    return (np.stack([columns, rows], axis=-1) + 0.5) * resolution


def pooled(levels: np.ndarray, block: int) -> np.ndarray:
    """
    Return the highest level of each square of cells, (rows, columns); what is left over counts.

    :param levels: (rows, columns).
    :param block: side of a square, in cells.
    """
    if block == 1:
        return levels
    rows, columns = (-(-size // block) for size in levels.shape)
    missing = [(0, rows * block - levels.shape[0]), (0, columns * block - levels.shape[1])]
    padded = np.pad(levels, missing, constant_values=-1)
    return padded.reshape(rows, block, columns, block).max(axis=(1, 3))


def surrounding_discs(
    points: np.ndarray,
    robot: np.ndarray,
    people_position: np.ndarray,
    people_radius: np.ndarray,
    settings: SurfaceSettings,
    depth: float = 0.0,
    rays: Rays | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return discs that stand for surfaces: centres, m, (discs, 2), and radii, m, (discs,).

    What looks round from outside, and is crossed by no ray, becomes one disc. For the rest, the
    nearest point in each sector counts: a disc lies behind it, seen from the robot, so that its
    rim touches the point and the clearance is that of the surface. Sectors begin at the world's x
    axis, so that they stay where they are when the robot turns.

    Rays may cross a disc of a sector, beside the surface that it touches and no farther from it
    than its diameter. Shrunk until none does, discs would leave gaps in a wall that is seen at an
    angle which look wide enough for the robot: at 3 m, 18 sectors are 1 m apart.

    :param points: on surfaces, m, (points, 2).
    :param robot: its centre, m, (2,).
    :param people_position: known people, whose returns are left out, m, (people, 2).
    :param people_radius: of them, m, (people,).
    :param depth: how much nearer than its point a surface may be, m.
    :param rays: on which nothing is; without them the ways from the robot to what it sees.
    """
    offset = points - robot
    distance = np.hypot(offset[:, 0], offset[:, 1])
    wanted = (distance <= settings.max_range) & (distance > settings.footprint)
    wanted &= np.abs(points).max(axis=1, initial=0.0) < settings.bounds
    near = np.hypot(*(people_position - robot).T) - people_radius <= settings.max_range + 1.0
    masks = people_position[near], people_radius[near] + settings.people_margin
    wanted[wanted] = ~within(points[wanted], *masks)
    visible = nearest_of_sectors(offset[wanted], VISIBLE_SECTORS)
    free = Rays(np.zeros(2), visible) if rays is None else rays.seen_from(robot)
    centres, radii = round_things(visible, free, settings, depth)
    rest = visible[~within(visible, centres, radii + RIM_TOLERANCES * settings.circle_tolerance)]
    points = nearest_of_sectors(rest, settings.sectors)
    distance = np.hypot(points[:, 0], points[:, 1])
    behind = np.maximum(distance - depth, 0.0) + settings.disc_radius
    discs = points * (behind / distance)[:, None]
    small = np.full(len(discs), settings.disc_radius)
    return robot + np.concatenate([centres, discs]), np.concatenate([radii + depth, small])


def round_things(
    visible: np.ndarray, rays: Rays, settings: SurfaceSettings, depth: float
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return the circles that may be discs: centres, m, (circles, 2), and radii, m, (circles,).

    :param visible: points as seen from the robot, m, (points, 2).
    :param rays: on which nothing is, likewise.
    :param depth: how much a circle grows, m; not over the robot.
    """
    tolerance = settings.circle_tolerance
    limits = settings.smallest_circle, settings.largest_circle, tolerance
    centres, radii = circles_of(visible, *limits)
    good = np.hypot(centres[:, 0], centres[:, 1]) > radii + depth
    good &= ~crossed(centres, radii, rays, RIM_TOLERANCES * tolerance)
    return centres[good], radii[good]


def nearest_of_sectors(offset: np.ndarray, sectors: int) -> np.ndarray:
    """
    Return the nearest point in each sector where there is one, m, (nearest, 2).

    :param offset: of the points from the robot, m, (points, 2).
    """
    turn = np.arctan2(offset[:, 1], offset[:, 0]) / (2 * np.pi) % 1.0
    sector = (turn * sectors).astype(int) % sectors
    farthest_first = np.argsort(-np.hypot(offset[:, 0], offset[:, 1]), kind='stable')
    nearest = np.full(sectors, -1)
    nearest[sector[farthest_first]] = farthest_first  # the last one written stays
    return offset[nearest[nearest >= 0]]


def within(points: np.ndarray, centres: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """
    Return which points lie in some disc, bool (points,).

    :param points: m, (points, 2).
    :param centres: of the discs, m, (discs, 2).
    :param radii: of the discs, m, (discs,).
    """
    gap = points[:, None] - centres
    return (np.hypot(gap[..., 0], gap[..., 1]) <= radii).any(axis=1)
