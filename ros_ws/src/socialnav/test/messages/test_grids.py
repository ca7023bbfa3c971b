"""What a map shows near a robot; no middleware is needed for it."""

import dataclasses
import math

from helpers.controllers import controller_of, SECOND, SETTINGS
from helpers.worlds import apart, quaternion_of, random_state
from nav_msgs.msg import OccupancyGrid
import numpy as np
import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.messages.grids import grid_discs, grid_points
from socialnav.messages.occupancy import map_message
from socialnav.messages.stamps import header_message
from socialnav_core.sensing import Pose

HALF_CELL = 0.5 * math.sqrt(0.5)
"""From the middle of a cell of half a metre to its corner, m."""


def grid_of(cells, resolution=0.5, corner=(-5.0, -5.0), heading=0.0, size=20):
    """Return a map in which some cells, given as column and row, are occupied."""
    grid = OccupancyGrid(header=header_message(SECOND, 'odom'))
    grid.info.resolution, grid.info.width, grid.info.height = resolution, size, size
    grid.info.origin.position.x, grid.info.origin.position.y = corner
    grid.info.origin.orientation = quaternion_of(heading)
    levels = np.zeros((size, size), dtype=np.int8)
    for column, row in cells:
        levels[row, column] = 100
    grid.data = levels.ravel().tolist()
    return grid


def cells_seen(grid, robot=(0.0, 0.0), **options):
    """Return the centres of the cells behind whose nearest corners the discs lie."""
    centres, radii = grid_discs(grid, np.array(robot), 'odom', **options)
    way = centres - robot
    distance = np.linalg.norm(way, axis=1, keepdims=True)
    return robot + way / distance * (distance - radii[:, None] + HALF_CELL)


def test_cells_of_a_turned_grid_are_where_its_origin_puts_them():
    grid = OccupancyGrid(header=header_message(SECOND, 'odom'), data=[0, 100])
    grid.info.width, grid.info.height, grid.info.resolution = 2, 1, 0.5
    grid.info.origin.position.x = 1.0
    grid.info.origin.orientation = quaternion_of(math.pi / 2)
    np.testing.assert_allclose(
        grid_points(grid, 65, np.zeros(2), 9.0), [[1.0 - 0.25, 0.75]], atol=1e-6
    )


def test_the_cells_of_a_map_lie_on_its_obstacles_and_walls():
    state = random_state(2)
    points = grid_points(map_message(state, SECOND, 'odom'), 65, np.zeros(2), np.inf)
    static = state.agents.static[0]
    gap = np.linalg.norm(points[:, None] - state.agents.position[0, static], axis=-1)
    on_something = (gap <= state.agents.radius[0, static]).any(axis=1)
    on_something |= np.abs(points).max(axis=1) > state.bounds[0]
    assert len(points) > 100 and on_something.all()


def test_an_occupied_cell_is_a_disc_behind_its_nearest_corner():
    centres, radii = grid_discs(grid_of([(14, 10)]), np.array([0.0, 0.25]), 'odom')
    np.testing.assert_allclose(centres, [(2.25 - HALF_CELL + 0.3, 0.25)])
    np.testing.assert_allclose(radii, 0.3)


def test_unknown_and_nearly_free_cells_are_no_obstacles():
    grid = grid_of([])
    grid.data[0], grid.data[1], grid.data[2] = -1, 64, 65
    np.testing.assert_allclose(cells_seen(grid, (-5.0, -5.0)), [(-3.75, -4.75)])


def test_cells_out_of_range_are_not_looked_at():
    grid = grid_of([(0, 0), (19, 19)], corner=(0.0, 0.0))
    np.testing.assert_allclose(cells_seen(grid, (1.0, 1.0)), [(0.25, 0.25)])
    assert len(cells_seen(grid, (-9.0, 0.0))) == len(cells_seen(grid, (100.0, 100.0))) == 0


def test_a_map_that_is_turned_and_lies_in_another_frame_shows_the_same_places():
    grid = grid_of([(14, 10)], corner=(0.0, 0.0), heading=math.pi / 2)
    np.testing.assert_allclose(cells_seen(grid, (-5.0, 5.0)), [(-5.25, 7.25)])
    grid.header.frame_id = 'map'
    asked = []

    def locate(frame, source, stamp):
        asked.append((frame, source, stamp))
        return Pose(1.0, 2.0, math.pi / 2)

    np.testing.assert_allclose(cells_seen(grid, (-5.0, -3.0), locate=locate), [(-6.25, -3.25)])
    assert asked == [('odom', 'map', 0)]


def change(grid, path, value):
    """Change one field of a map."""
    *way, last = path.split('.')
    for step in way:
        grid = getattr(grid, step)
    setattr(grid, last, value)


@pytest.mark.parametrize(
    ('path', 'value', 'reason'),
    [
        ('info.resolution', math.nan, 'resolution'),
        ('info.width', 21, '400 cells instead of 21 times 20'),
        ('info.origin.position.x', math.inf, 'origin'),
        ('info.origin.orientation.w', 7.0, 'orientation'),
        ('header.frame_id', 'map', "in frame 'map'"),
    ],
)
def test_a_map_that_cannot_be_is_refused(path, value, reason):
    grid = grid_of([(14, 10)])
    change(grid, path, value)
    with pytest.raises(ConversionError, match=f'^map: .*{reason}'):
        cells_seen(grid)


def controller_with_map(policy, state, **changes):
    """Return a controller that uses the map of a world."""
    settings = dataclasses.replace(SETTINGS, use_map=True, require_obstacles=False, **changes)
    controller = controller_of(policy, settings, without=['obstacles'], state=state)
    controller.store('map', map_message(state, SECOND, 'odom'))
    return controller


def test_every_obstacle_near_the_robot_is_found_again_in_the_map(policy):
    state = random_state(3, pedestrians=2, obstacles=2)
    state.agents.position[0, 2:] = state.robot.position[0] + [(2.0, 0.0), (0.0, -3.0)]
    controller_with_map(policy, state).decide(SECOND)
    seen = policy.states[0]
    discs, radii = (
        seen.agents.position[0, seen.agents.static[0]],
        seen.agents.radius[0, seen.agents.static[0]],
    )
    robot = state.robot.position[0]
    for centre, radius in zip(
        state.agents.position[0, 2:], state.agents.radius[0, 2:], strict=True
    ):
        on_it = np.linalg.norm(discs - centre, axis=1) < radius + radii
        clearance = (np.linalg.norm(discs - robot, axis=1) - radii)[on_it].min()
        assert abs(clearance - (np.linalg.norm(centre - robot) - radius)) < 0.15
    assert seen.agents.static[0].sum() > 2 and (~seen.agents.static[0]).sum() == 2


def test_what_the_map_shows_takes_no_place_from_people(policy):
    state = random_state(3, pedestrians=5, obstacles=1)
    state = apart(state)
    state.agents.position[0, 5] = state.robot.position[0] + (1.0, 0.0)
    controller_with_map(policy, state, max_agents=5).decide(SECOND)
    assert (~policy.states[0].agents.static[0]).sum() == 5


def test_without_the_map_the_robot_stands(policy):
    settings = dataclasses.replace(SETTINGS, use_map=True)
    assert controller_of(policy, settings).decide(SECOND).reason == 'no map'


def test_a_map_that_is_not_wanted_changes_nothing(policy):
    controller = controller_of(policy)
    controller.store('map', grid_of([(14, 10)]))
    controller.decide(SECOND)
    assert policy.states[0].agents.count == 5
