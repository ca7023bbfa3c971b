"""The static part of a world as a grid."""

import array

from nav_msgs.msg import OccupancyGrid
import numpy as np

from socialnav.messages.stamps import header_message
from socialnav_core.states import CrowdState

RESOLUTION = 0.1
MARGIN = 1.0
OCCUPIED = 100


def map_message(state: CrowdState, nanoseconds: int, frame: str) -> OccupancyGrid:
    """Return obstacles, and any walls, of the first world as cells of 0.1 m."""
    half_width = extent(state)
    cells = 2 * int(np.ceil(half_width / RESOLUTION))
    grid = OccupancyGrid(header=header_message(nanoseconds, frame))
    grid.info.map_load_time = grid.header.stamp
    grid.info.resolution = RESOLUTION
    grid.info.width = grid.info.height = cells
    grid.info.origin.position.x = grid.info.origin.position.y = -cells * RESOLUTION / 2
    grid.info.origin.orientation.w = 1.0
    levels = np.where(occupied(state, cells), OCCUPIED, 0).astype(np.int8)
    grid.data = array.array('b', levels.tobytes())
    return grid


def extent(state: CrowdState) -> float:
    """Return the half-width of a map that shows the whole of the first world, m."""
    if np.isfinite(state.bounds[0]):
        return float(state.bounds[0]) + MARGIN
    points = [
        state.robot.position[0],
        state.robot.goal[0],
        *state.agents.position[0][state.agents.valid[0]],
    ]
    return float(np.abs(points).max()) + MARGIN


def occupied(state: CrowdState, cells: int) -> np.ndarray:
    """Return which cells of the first world are not free, bool (cells, cells), rows along y."""
    centres = (np.arange(cells) + 0.5 - cells / 2) * RESOLUTION
    x, y = np.meshgrid(centres, centres)
    taken = np.maximum(np.abs(x), np.abs(y)) > state.bounds[0]
    for index in np.flatnonzero(state.agents.valid[0] & state.agents.static[0]):
        (centre_x, centre_y), radius = (
            state.agents.position[0, index],
            state.agents.radius[0, index],
        )
        taken |= np.hypot(x - centre_x, y - centre_y) <= radius
    return taken
