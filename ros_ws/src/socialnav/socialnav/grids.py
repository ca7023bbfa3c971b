"""Occupied cells of a map near the robot as obstacles."""

import dataclasses
import math

from nav_msgs.msg import OccupancyGrid
import numpy as np

from socialnav.conversions import ConversionError, finite, heading_of, placement_of
from socialnav.frames import Locate, not_asked, Placement
from socialnav.sectors import LEAST_RADIUS, MAX_RANGE, nearest_of_sectors
from socialnav_core.states import CrowdState

OCCUPIED = 65
"""Cells of at least so many percent are occupied; unknown ones (-1) are free."""


def grid_discs(
    grid: OccupancyGrid, robot_position: np.ndarray, frame: str, locate: Locate = not_asked
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return centres (discs, 2) and radii (discs,) of what stands nearest in each direction, m.

    :param grid: a map; its stamp means nothing, since it may have been loaded long ago.
    :param robot_position: in the frame that is wanted, m, (2,).
    :param frame: the frame that is wanted.
    :param locate: says where other frames lie in it.
    :raises ConversionError: a map that cannot be, or in a frame that nobody knows.
    """
    cells, resolution = checked_cells(grid)
    pose = grid.info.origin
    x, y = finite('map', 'origin', [pose.position.x, pose.position.y]).tolist()
    origin = Placement(x, y, heading_of('map', pose.orientation))
    corner = origin.within(placement_of('map', grid.header, frame, locate, newest=True))
    centre = corner.found(np.asarray(robot_position))
    near = occupied_near(cells, resolution, centre)
    chosen = corner.placed(near[nearest_of_sectors(near - centre)])
    radius = max(resolution * math.sqrt(0.5), LEAST_RADIUS)
    return chosen, np.full(len(chosen), radius)


def with_discs(state: CrowdState, centres: np.ndarray, radii: np.ndarray) -> CrowdState:
    """
    Return a state with more obstacles.

    :param state: batch of one.
    :param centres: m, (discs, 2).
    :param radii: m, (discs,).
    """
    count = len(radii)
    more = {
        'position': centres,
        'velocity': np.zeros((count, 2)),
        'radius': radii,
        'static': np.ones(count, dtype=bool),
        'valid': np.ones(count, dtype=bool),
    }
    joined = {
        name: np.concatenate([getattr(state, name), array[None]], axis=1)
        for name, array in more.items()
    }
    return dataclasses.replace(state, **joined)


def checked_cells(grid: OccupancyGrid) -> tuple[np.ndarray, float]:
    """
    Return the cells (rows along y, columns along x) and their side, m.

    :param grid: a map.
    :raises ConversionError: a map that cannot be.
    """
    info = grid.info
    if not 0 < info.resolution < math.inf:
        raise ConversionError(f'map: resolution of {info.resolution:g} m')
    if len(grid.data) != info.width * info.height:
        raise ConversionError(
            f'map: {len(grid.data)} cells instead of {info.width} times {info.height}'
        )
    cells = np.asarray(grid.data, dtype=np.int8).reshape(info.height, info.width)
    return cells, float(info.resolution)


def occupied_near(cells: np.ndarray, resolution: float, centre: np.ndarray) -> np.ndarray:
    """
    Return the centres of the occupied cells in a square around a point, m, (cells, 2).

    :param cells: percent, rows along y.
    :param resolution: side of a cell, m.
    :param centre: of the square, whose half-width is the range, from the map's corner, m, (2,).
    """
    limits = np.array([cells.shape[1], cells.shape[0]])
    low = np.clip(np.floor((centre - MAX_RANGE) / resolution).astype(int), 0, limits)
    high = np.clip(np.ceil((centre + MAX_RANGE) / resolution).astype(int), 0, limits)
    rows, columns = np.nonzero(cells[low[1] : high[1], low[0] : high[0]] >= OCCUPIED)
    return (np.stack([columns, rows], axis=1) + low + 0.5) * resolution
