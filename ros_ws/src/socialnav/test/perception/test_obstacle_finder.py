"""Laws of finding obstacles, without the middleware."""

from helpers.worlds import messages_of, random_state
import numpy as np
import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.messages.occupancy import map_message
from socialnav.messages.sensor_messages import scan_message
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.perception.obstacle_finder import ObstacleFinder
from socialnav_core.sensing import beam_angles, cast_rays

SECOND = 10**9
WALL = 2.0
"""How far ahead the scanner sees something, m."""


def state_at(position=(0.0, 0.0), heading=0.0, pedestrians=0):
    """Return a world with a robot that stands somewhere."""
    state = random_state(0, pedestrians=pedestrians, obstacles=2)
    state.robot.position[:], state.robot.velocity[:] = position, 0.0
    state.robot.heading[:] = heading
    return state


def odometry(stamp=SECOND, **pose):
    return messages_of(state_at(**pose), stamp)['odom']


def scan(stamp=SECOND, beams=36, ahead=WALL):
    """Return a scan whose beam straight ahead sees something."""
    ranges = np.full(beams, np.inf)
    ranges[beams // 2] = ahead
    return scan_message(ranges, 10.0, 0.05, stamp, 'laser')


def finder(**values):
    result = ObstacleFinder(ObstacleParameters(**values))
    result.store_odometry(odometry())
    return result


def rims(message, robot=(0.0, 0.0)):
    """Return the points of discs that are nearest to the robot, (discs, 2)."""
    found = [(agent.position.x, agent.position.y, agent.radius) for agent in message.agents]
    centre, radius = np.array(found).reshape(-1, 3)[:, :2], [agent[2] for agent in found]
    distance = np.linalg.norm(centre - robot, axis=1)
    return robot + (centre - robot) * (1 - radius / distance)[:, None]


def test_a_return_is_where_the_robot_was_and_looked_when_it_was_measured():
    robot = finder()
    robot.store_odometry(odometry(2 * SECOND, position=(1.0, 3.0), heading=np.pi / 2))
    message = robot.of_scan(scan(2 * SECOND))
    np.testing.assert_allclose(rims(message, (1.0, 3.0)), [[1.0, 3.0 + WALL]], atol=1e-6)
    assert nanoseconds_of(message.header.stamp) == 2 * SECOND
    assert message.header.frame_id == 'odom'


def test_a_return_between_two_odometries_is_seen_from_between_them():
    robot = finder()
    robot.store_odometry(odometry(SECOND + SECOND // 10, position=(1.0, 0.0)))
    message = robot.of_scan(scan(SECOND + SECOND // 20))
    np.testing.assert_allclose(rims(message, (0.5, 0.0)), [[0.5 + WALL, 0.0]], atol=1e-6)


def test_a_laser_that_looks_backwards_from_the_front_sees_what_is_behind():
    robot = finder(laser_x=0.5, laser_yaw=np.pi)
    np.testing.assert_allclose(rims(robot.of_scan(scan())), [[0.5 - WALL, 0.0]], atol=1e-6)


def test_a_scan_of_a_time_without_odom_is_refused():
    with pytest.raises(ConversionError, match='no odom within 0.2 s'):
        finder().of_scan(scan(2 * SECOND))


def test_a_scan_in_free_space_is_no_obstacle():
    assert finder().of_scan(scan(ahead=np.inf)).agents == []


def walker(stamp, velocity=1.0, x=WALL):
    """Return one pedestrian on the x axis."""
    state = state_at(pedestrians=1)
    state.agents.position[0, 0], state.agents.velocity[0, 0], state.agents.radius[0, 0] = (
        (x, 0),
        (velocity, 0),
        0.3,
    )
    return messages_of(state, stamp)['pedestrians']


def test_a_known_pedestrian_is_no_obstacle():
    robot = finder()
    robot.store_people(walker(SECOND))
    assert robot.of_scan(scan()).agents == []


def test_a_pedestrian_is_looked_for_where_it_is_at_the_time_of_the_scan():
    robot = finder(people_margin=0.0)
    robot.store_people(walker(SECOND - SECOND // 2, x=WALL - 0.5))
    assert robot.of_scan(scan()).agents == []


def test_a_pedestrian_of_whom_nothing_is_heard_any_more_is_an_obstacle():
    robot = finder(people_timeout=0.5)
    robot.store_people(walker(SECOND - 6 * SECOND // 10, velocity=0.0))
    assert len(robot.of_scan(scan()).agents) == 1


def test_pedestrians_that_cannot_be_are_refused_and_mask_nothing():
    robot = finder()
    robot.store_people(walker(SECOND))
    with pytest.raises(ConversionError, match='pedestrians: velocity with NaN'):
        robot.store_people(walker(SECOND, velocity=np.nan))
    assert len(robot.of_scan(scan()).agents) == 1


def test_surfaces_beyond_the_bounds_do_not_count():
    assert len(finder(bounds=2.1).of_scan(scan()).agents) == 1
    assert finder(bounds=1.9).of_scan(scan()).agents == []


def test_a_grid_shows_obstacles_no_nearer_than_a_cell_and_no_farther_than_they_are():
    state = state_at((0.0, 0.0))
    state.agents.position[0], state.agents.radius[0], state.bounds[:] = (
        [(3, 0), (0, -4)],
        [1.0, 0.5],
        np.inf,
    )
    robot = finder(source='grid', sectors=360)
    robot.store_grid(map_message(state, 0, 'odom'))
    found = np.linalg.norm(rims(robot.of_grid()), axis=1)
    true, _ = cast_rays(
        np.zeros(2), beam_angles(3600), state.agents.position[0], state.agents.radius[0]
    )
    assert true.min() - 0.15 < found.min() <= true.min()


def test_a_grid_is_answered_once_for_each_odometry():
    robot = finder(source='grid')
    robot.store_grid(map_message(state_at(), 0, 'odom'))
    assert nanoseconds_of(robot.of_grid().header.stamp) == SECOND
    assert robot.of_grid() is None
    robot.store_odometry(odometry(2 * SECOND))
    assert nanoseconds_of(robot.of_grid().header.stamp) == 2 * SECOND


@pytest.mark.parametrize('timeout', [0.0, 1.5])
def test_a_grid_that_is_not_older_than_its_time_out_is_answered(timeout):
    robot = finder(source='grid', grid_timeout=timeout)
    robot.store_grid(map_message(state_at(), 0, 'odom'))
    assert robot.of_grid() is not None


def test_without_a_grid_or_odom_or_with_an_old_grid_the_reason_is_told():
    robot = ObstacleFinder(ObstacleParameters(source='grid', grid_timeout=0.5))
    with pytest.raises(ConversionError, match='no map'):
        robot.of_grid()
    robot.store_grid(map_message(state_at(), 0, 'odom'))
    with pytest.raises(ConversionError, match='no odom'):
        robot.of_grid()
    robot.store_odometry(odometry())
    with pytest.raises(ConversionError, match='map older than 0.5 s'):
        robot.of_grid()


def test_a_grid_in_another_frame_is_refused():
    with pytest.raises(ConversionError, match="map: in frame 'map'"):
        finder(source='grid').store_grid(map_message(state_at(), 0, 'map'))
