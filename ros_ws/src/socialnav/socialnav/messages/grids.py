"""Occupied cells of a map or costmap near the robot as obstacles."""

import dataclasses
import math

from nav_msgs.msg import OccupancyGrid
import numpy as np

from socialnav.messages.conversions import ConversionError, finite, heading_of, placement_of
from socialnav.messages.frames import Locate, not_asked
from socialnav_core.sensing import (
    grid_returns,
    pooled,
    Pose,
    SurfaceSettings,
    surrounding_discs,
)
from socialnav_core.states import Agents, CrowdState

HALF_DIAGONAL = 0.5**0.5
"""Of a cell, in sides: a surface may be so much nearer than the centre of its cell."""
SURFACES = SurfaceSettings()
NOBODY = np.empty((0, 2)), np.empty(0)
"""Positions and radii of known people, who are in no map."""
FINEST = 0.05
"""Side of the cells that finer ones are put together to, about, m; it bounds the work."""
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
    :raises ConversionError: a map that cannot be, or in a frame that nobody knows.
    """
    place = placement_of('map', grid.header, frame, locate, newest=True)
    centre = place.found(robot_position)
    points = place.placed(grid_points(grid, OCCUPIED, centre, SURFACES.max_range))
    return surrounding_discs(points, robot_position, *NOBODY, SURFACES, grid_depth(grid))


def grid_points(
    grid: OccupancyGrid, threshold: int, centre: np.ndarray, reach: float
) -> np.ndarray:
    """
    Return the centres of the occupied cells around a place, in the grid's frame, m, (cells, 2).

    :param threshold: smallest level of an occupied cell, percent.
    :param centre: the place, in the frame of the grid, m, (2,).
    :param reach: cells nearer than this along both axes of the grid are among them, m.
    :raises ConversionError: a grid that cannot be.
    """
    corner, cells, resolution = corner_of(grid), cells_of(grid), grid.info.resolution
    centre, limits = corner.found(centre), np.array(cells.shape)[::-1]
    low = np.clip(np.floor((centre - reach) / resolution), 0, limits).astype(int)
    high = np.clip(np.ceil((centre + reach) / resolution), 0, limits).astype(int)
    window = cells[low[1] : high[1], low[0] : high[0]]
    block = block_of(grid)
    cells = pooled(window, block)
    return corner.placed(low * resolution + grid_returns(cells, block * resolution, threshold))


def block_of(grid: OccupancyGrid) -> int:
    """Return the side of the squares of cells that are looked at as one."""
    return max(round(FINEST / grid.info.resolution), 1)


def grid_depth(grid: OccupancyGrid) -> float:
    """Return how much nearer than a point of grid_points() its surface may be, m."""
    return HALF_DIAGONAL * block_of(grid) * grid.info.resolution


def with_discs(state: CrowdState, centres: np.ndarray, radii: np.ndarray) -> CrowdState:
    """
    Return a state with more obstacles.

    :param state: batch of one.
    :param centres: m, (discs, 2).
    :param radii: m, (discs,).
    """
    count = len(radii)
    discs = Agents(
        centres[None],
        np.zeros((1, count, 2)),
        radii[None],
        static=np.ones((1, count), dtype=bool),
        valid=np.ones((1, count), dtype=bool),
    )
    return dataclasses.replace(state, agents=state.agents.append(discs))


def corner_of(grid: OccupancyGrid) -> Pose:
    """
    Return where the corner of the first cell lies, and how the rows are turned.

    :raises ConversionError: a grid that cannot be.
    """
    pose = grid.info.origin
    x, y = finite('map', 'origin', [pose.position.x, pose.position.y]).tolist()
    return Pose(x, y, heading_of('map', pose.orientation))


def cells_of(grid: OccupancyGrid) -> np.ndarray:
    """
    Return the cells, percent, -1 where nothing is known, int8 (rows along y, columns along x).

    :raises ConversionError: a grid that cannot be.
    """
    info = grid.info
    if not FINEST / 1000 < info.resolution < math.inf:
        raise ConversionError(f'map: resolution of {info.resolution:g} m')
    if len(grid.data) != info.width * info.height:
        raise ConversionError(
            f'map: {len(grid.data)} cells instead of {info.width} times {info.height}'
        )
    return np.asarray(grid.data, dtype=np.int8).reshape(info.height, info.width)
