"""From scans or grids to the discs that a policy avoids; knows no rclpy."""

from nav_msgs.msg import OccupancyGrid, Odometry
import numpy as np
from sensor_msgs.msg import LaserScan

from socialnav.messages.conversions import agent_arrays, ConversionError, placement_of
from socialnav.messages.frames import not_asked
from socialnav.messages.grids import cells_of, corner_of, grid_points, HALF_DIAGONAL
from socialnav.messages.sensor_messages import discs_message, scan_points
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.perception.locating import Locator
from socialnav_core.sensing import Pose, SurfaceSettings, surrounding_discs
from socialnav_msgs.msg import AgentStates


class ObstacleFinder:
    """Keeps odometry, pedestrians and a grid; finds obstacles."""

    def __init__(self, settings: ObstacleParameters) -> None:
        """
        Start without any input.

        :param settings: may be replaced at any time.
        """
        self.settings = settings
        self.locator = Locator(settings.planning_frame, 'base_link', settings.pose_timeout)
        self._people: AgentStates | None = None
        self._grid: OccupancyGrid | None = None
        self._answered = -1

    def store_odometry(self, message: Odometry) -> None:
        """
        Keep a pose of the robot.

        :raises ConversionError: a pose that cannot be used.
        """
        self.locator.store(message)

    def store_people(self, message: AgentStates) -> None:
        """
        Keep who walks.

        :raises ConversionError: pedestrians that cannot be used; none are known then.
        """
        self._people = None
        agent_arrays('pedestrians', message, self.locator.planning_frame, static=False)
        self._people = message

    def store_grid(self, message: OccupancyGrid) -> None:
        """
        Keep a grid, which is a map or a local costmap.

        :raises ConversionError: a grid that cannot be used; none is known then.
        """
        self._grid = None
        placement_of('map', message.header, self.settings.grid_frame, not_asked)
        corner_of(message)
        cells_of(message)
        self._grid = message

    def of_scan(self, message: LaserScan) -> AgentStates:
        """
        Return what stands around the robot at the time of a scan.

        :raises ConversionError: a scan that cannot be used, or no pose of the robot at its time.
        """
        stamp, settings = nanoseconds_of(message.header.stamp), self.settings
        robot = self.locator.base(stamp)
        laser = robot.of(Pose(settings.laser_x, settings.laser_y, settings.laser_yaw))
        return self._obstacles(laser.placed(scan_points(message)), robot, stamp, 0.0)

    def of_grid(self) -> AgentStates | None:
        """
        Return what stands around the robot at the time of the newest odom, None if it is not new.

        :raises ConversionError: no grid, an old one, or no pose of the robot.
        """
        stamp, grid, timeout = self.locator.latest, self._grid, self.settings.grid_timeout
        if stamp == self._answered:
            return None
        if grid is None:
            raise ConversionError('no map')
        if 0 < timeout < (stamp - nanoseconds_of(grid.header.stamp)) * 1e-9:
            raise ConversionError(f'map older than {timeout:g} s')
        robot = self.locator.base(stamp)
        self._answered = stamp
        threshold, reach = self.settings.grid_threshold, self.settings.max_range
        points = grid_points(grid, threshold, robot.position, reach)
        depth = HALF_DIAGONAL * grid.info.resolution
        return self._obstacles(points, robot, stamp, depth)

    def _obstacles(self, points: np.ndarray, robot: Pose, stamp: int, depth: float) -> AgentStates:
        """Return the discs behind points of surfaces."""
        people, surfaces = self._people_at(stamp), surface_settings(self.settings)
        discs = surrounding_discs(points, robot.position, *people, surfaces, depth)
        return discs_message(*discs, stamp, self.locator.planning_frame)

    def _people_at(self, stamp: int) -> tuple[np.ndarray, np.ndarray]:
        """Return where known people are by then, (people, 2), and their radii; none if unknown."""
        people, frame = self._people, self.locator.planning_frame
        age = 0.0 if people is None else (stamp - nanoseconds_of(people.header.stamp)) * 1e-9
        if abs(age) > self.settings.people_timeout:
            people = None
        position, velocity, radius, _ = agent_arrays('pedestrians', people, frame, static=False)
        return position + age * velocity, radius


def surface_settings(settings: ObstacleParameters) -> SurfaceSettings:
    """Return how discs are made of surfaces."""
    return SurfaceSettings(
        sectors=settings.sectors,
        disc_radius=settings.disc_radius,
        max_range=settings.max_range,
        largest_circle=settings.largest_circle,
        bounds=settings.bounds,
        people_margin=settings.people_margin,
    )
