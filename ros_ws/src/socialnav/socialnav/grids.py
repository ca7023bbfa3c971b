"""Occupied cells of a map near the robot as obstacles."""

import dataclasses
import math

from nav_msgs.msg import OccupancyGrid
import numpy as np

from socialnav.conversions import ConversionError, finite, heading_of, placement_of
from socialnav.frames import Locate, not_asked
from socialnav.obstacle_finder import HALF_DIAGONAL
from socialnav_core.sensing import Pose, surrounding_discs, SurfaceSettings
from socialnav_core.states import CrowdState

SURFACES = SurfaceSettings()
NOBODY = np.empty((0, 2)), np.empty(0)
"""Positions and radii of known people, who are in no map."""
OCCUPIED = 65
"""Cells of at least so many percent are occupied; unknown ones (-1) are free."""


def grid_discs(
    grid: OccupancyGrid, robot_position: np.ndarray, frame: str, locate: Locate = not_asked
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return centres (discs, 2) and radii (discs,) of what stands around the robot, m.

    They are made as `obstacle_node` makes them.

    :param grid: a map; its stamp means nothing, since it may have been loaded long ago.
    :param robot_position: in the frame that is wanted, m, (2,).
    :param frame: the frame that is wanted.
    :param locate: says where other frames lie in it.
    :raises ConversionError: a map that cannot be, or in a frame that nobody knows.
    """
    cells, resolution = checked_cells(grid)
    pose = grid.info.origin
    x, y = finite('map', 'origin', [pose.position.x, pose.position.y]).tolist()
    origin = Pose(x, y, heading_of('map', pose.orientation))
    corner = placement_of('map', grid.header, frame, locate, newest=True).of(origin)
    near = corner.placed(occupied_near(cells, resolution, corner.found(robot_position)))
    depth = HALF_DIAGONAL * resolution
    return surrounding_discs(near, robot_position, *NOBODY, SURFACES, depth)


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
    low = np.clip(np.floor((centre - SURFACES.max_range) / resolution).astype(int), 0, limits)
    high = np.clip(np.ceil((centre + SURFACES.max_range) / resolution).astype(int), 0, limits)
    rows, columns = np.nonzero(cells[low[1] : high[1], low[0] : high[0]] >= OCCUPIED)
    return (np.stack([columns, rows], axis=1) + low + 0.5) * resolution
