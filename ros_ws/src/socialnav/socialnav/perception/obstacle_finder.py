"""From scans or grids to the discs that a policy avoids; knows no rclpy."""

import dataclasses

from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid, Odometry
import numpy as np
from sensor_msgs.msg import LaserScan

from socialnav.messages.conversions import (
    agent_arrays,
    ConversionError,
    merged_arrays,
    placement_of,
)
from socialnav.messages.frames import not_asked
from socialnav.messages.grids import cells_of, corner_of, grid_depth, grid_points
from socialnav.messages.sensor_messages import discs_message, scan_points
from socialnav.messages.sources import source_of
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.perception.lasers import Lasers, Transform
from socialnav.perception.locating import Locator
from socialnav_core.sensing import Pose, Rays, Readings, SurfaceSettings, surrounding_discs
from socialnav_msgs.msg import AgentStates

ROOM = 10.0
"""How far behind the last surface that counts a ray may show that nothing is, m."""
SILENCE = 1.0
"""Time behind the newest scan after which another one stays away, s."""
MOST_PEOPLE = 300
"""Number of known people above which they are refused."""
MOST_SPEAKERS = 16
"""Number of publishers of people of whom the newest list is kept."""


def no_transform(frame: str, source: str) -> TransformStamped:
    """Refuse, where nobody knows tf."""
    raise LookupError('nobody tells where it is')


@dataclasses.dataclass(frozen=True)
class Found:
    """What the newest scan of a topic found."""

    stamp: int
    """Time of the scan, ns."""
    centres: np.ndarray
    """Of the discs, in the planning frame, m, (discs, 2)."""
    radii: np.ndarray
    """Of the discs, m, (discs,)."""


class ObstacleFinder:
    """Keeps odometry, pedestrians and a grid; finds obstacles."""

    def __init__(
        self, settings: ObstacleParameters, transform: Transform = no_transform, source: str = ''
    ) -> None:
        """
        Start without any input.

        :param settings: may be replaced at any time.
        :param transform: asked how lasers sit where that is wanted.
        :param source: who finds the obstacles.
        :raises ValueError: settings that tell too little.
        """
        self.settings = settings
        frames = settings.planning_frame, settings.base_frame
        self.locator = Locator(*frames, settings.pose_timeout)
        self.lasers = Lasers(settings, transform)
        self._source = source
        self._people: dict[str, AgentStates] = {}
        self._found: dict[str, Found] = {}
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

        :raises ConversionError: pedestrians that cannot be used; none from there are known then.
        """
        self._people.pop(source_of(message), None)
        if len(message.agents) > MOST_PEOPLE:
            raise ConversionError(f'pedestrians: {len(message.agents)}, more than {MOST_PEOPLE}')
        agent_arrays('pedestrians', message, self.locator.planning_frame, static=False)
        self._people[source_of(message)] = message
        if len(self._people) > MOST_SPEAKERS:
            del self._people[next(iter(self._people))]

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

    def of_scan(self, message: LaserScan, topic: str = 'scan') -> AgentStates:
        """
        Return what stands around the robot by the newest scan of each topic, as of the oldest.

        :param topic: that the scan came on.
        :raises ConversionError: a scan that cannot be used, no pose of the robot at its time, or a
            topic that has had no scan yet.
        """
        stamp, settings = nanoseconds_of(message.header.stamp), self.settings
        mounting = self.lasers.mounting(topic, message.header.frame_id)
        hit, ends = scan_points(message, readings(settings), settings.max_range + ROOM)
        robot = self.locator.base(stamp)
        origin, hit, ends = (
            robot.placed(mounting.placed(points)) for points in (np.zeros((1, 2)), hit, ends)
        )
        discs = self._discs(hit, robot, stamp, 0.0, Rays(origin[0], ends))
        self._found[topic] = Found(stamp, *discs)
        missing = [name for name in self.lasers.topics if name not in self._found]
        if missing:
            raise ConversionError(f'no scan yet on {", ".join(missing)}')
        return self._of_all_scans()

    def silence(self) -> str | None:
        """Return which scans have stayed away while others came, or None."""
        newest = max((one.stamp for one in self._found.values()), default=0)
        silent = [
            f'no scan on {topic} for {(newest - one.stamp) * 1e-9:.1f} s'
            for topic, one in self._found.items()
            if newest - one.stamp > SILENCE * 1e9
        ]
        return '; '.join(silent) or None

    def _of_all_scans(self) -> AgentStates:
        """Return what the newest scans found."""
        found = self._found.values()
        centres = np.concatenate([one.centres for one in found])
        radii = np.concatenate([one.radii for one in found])
        return self._message(centres, radii, min(one.stamp for one in found))

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
        return self._message(*self._discs(points, robot, stamp, grid_depth(grid)), stamp)

    def _discs(
        self, points: np.ndarray, robot: Pose, stamp: int, depth: float, rays: Rays | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return centres and radii of the discs behind points of surfaces."""
        people, surfaces = self._people_at(stamp), surface_settings(self.settings)
        return surrounding_discs(points, robot.position, *people, surfaces, depth, rays)

    def _message(self, centres: np.ndarray, radii: np.ndarray, stamp: int) -> AgentStates:
        """Return discs as obstacles."""
        message = discs_message(centres, radii, stamp, self.locator.planning_frame)
        message.source = self._source
        return message

    def _people_at(self, stamp: int) -> tuple[np.ndarray, np.ndarray]:
        """Return where known people are by then, (people, 2), and their radii; none if unknown."""
        timeout = self.settings.people_timeout * 1e9
        stamps = {source: nanoseconds_of(one.header.stamp) for source, one in self._people.items()}
        known = [source for source in stamps if abs(stamp - stamps[source]) <= timeout]
        told = [self._people[source] for source in known]
        position, velocity, radius, _ = merged_arrays(
            'pedestrians', told, self.locator.planning_frame, static=False
        )
        age = (stamp - max((stamps[source] for source in known), default=stamp)) * 1e-9
        return position + age * velocity, radius


def readings(settings: ObstacleParameters) -> Readings:
    """Return what ranges that are no distance mean."""
    return Readings(
        inf=settings.inf_is,
        nan=settings.nan_is,
        zero=settings.zero_is,
        beyond=settings.range_max_is,
        least_valid=settings.valid_beams,
    )


def surface_settings(settings: ObstacleParameters) -> SurfaceSettings:
    """Return how discs are made of surfaces."""
    return SurfaceSettings(
        sectors=settings.sectors,
        disc_radius=settings.disc_radius,
        max_range=settings.max_range,
        largest_circle=settings.largest_circle,
        bounds=settings.bounds,
        people_margin=settings.people_margin,
        footprint=settings.footprint_radius,
    )
