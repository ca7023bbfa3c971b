"""Settings of a world: who is in it, how people move, what a step is worth."""

import dataclasses
import math
from typing import Annotated

from socialnav_core.config.mapping import require
from socialnav_core.config.ranges import (
    DIGEST,
    NAME,
    OneOf,
    Pattern,
    Point,
    Range,
    require_allowed,
)
from socialnav_core.config.recordings import INTERVAL

KINEMATICS = ('holonomic', 'differential')
CROWDS = {
    'orca': 'people avoid each other and obstacles, each doing its share',
    'non_reactive': 'people walk straight to their goals and react to nobody',
    'social_force': 'people push each other away, as in the social force model',
    'changing': 'as orca, but people change their goals, and new ones come for those who arrive',
    'stop_and_go': 'as orca, but people stop all of a sudden for 0.5 to 4 s',
    'distracted': 'as orca, but three in ten look at their phones and give way to nobody',
    'headed_social_force': 'as social_force, but people walk where they look',
    'groups': 'as social_force, but people walk in groups of two to four',
    'recorded': 'recorded people do again what they did, and react to nobody',
    'recorded_reactive': 'the same, but near the robot they avoid it, as orca',
}
"""What moves the people, by the names of the files in simulation/crowds."""
ROBOT_MATTERS = ('changing',)
"""Crowds in which nobody appears where the robot is."""
RECORDED = ('recorded', 'recorded_reactive')
"""Crowds of recorded people; scenarios of theirs are called by the crowd, a colon and a file."""
LAYOUTS = ('square_crossing', 'circle_crossing', 'open_square', 'recorded')
SCENARIO_NAME = Pattern(
    rf'({"|".join(RECORDED)}):[^\n]{{1,4000}}|{NAME.expression}', f'{NAME} or recorded:FILE'
)
FARTHEST = 1000.0
"""Largest coordinate of a start or goal that is chosen, m."""


@dataclasses.dataclass(frozen=True)
class OrcaConfig:
    """Optimal reciprocal collision avoidance (van den Berg et al. 2011)."""

    neighbor_distance: Annotated[float, Range(0, 1000)] = 10.0
    """Agents whose centres are farther than this are ignored, m."""
    max_neighbors: Annotated[int, Range(0, 1000)] = 10
    """The nearest so many agents, by centre distance, are avoided."""
    time_horizon: Annotated[float, Range(0.01, 100)] = 5.0
    """Collisions within this time are avoided, s."""
    safety_space: Annotated[float, Range(0, 5)] = 0.0
    """Added to every radius, m, besides the constant 0.01 m."""
    static_responsibility: Annotated[float, Range(0, 1)] = 0.5
    """Share of a conflict with an obstacle that the mover takes; 1 solves it alone."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class RewardConfig:
    """Reward of one step; terms as in CrowdNav and in the founding report."""

    goal: Annotated[float, Range(-1000, 1000)] = 1.0
    """For a step that ends at the goal."""
    collision: Annotated[float, Range(-1000, 1000)] = -0.25
    """For a step in which the robot touches a pedestrian or an obstacle."""
    out_of_bounds: Annotated[float, Range(-1000, 1000)] = -0.25
    """For a step that ends outside of the walls."""
    discomfort_distance: Annotated[float, Range(0, 10)] = 0.2
    """Clearance below which a step is penalised, m."""
    discomfort_factor: Annotated[float, Range(0, 1000)] = 0.5
    """Penalty per metre of missing clearance and per second."""
    walls_discomfort: bool = True
    """Whether clearance to the walls counts for discomfort."""
    discount: Annotated[float, Range(0.001, 1)] = 0.9
    """Discount per metre at preferred speed: gamma ** (time_step * preferred_speed) per step."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class RecordingConfig:
    """Recorded people, whom the crowds recorded and recorded_reactive are made of."""

    file: Annotated[str, Pattern(r'[^\n]{0,4000}', 'the path of a file, or nothing')] = ''
    """Text file, a line `frame person x y` for each person and frame, m; recorded crowds only."""
    interval: Annotated[float, Range(0.001, 10)] = INTERVAL
    """Time between two annotated frames, s."""
    digest: Annotated[str, DIGEST] = ''
    """SHA-256 of the file, so that another one is not taken for it; nothing: any."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class Scenario:
    """A world: who is in it, how an episode starts and when it ends."""

    name: Annotated[str, SCENARIO_NAME]
    """Name of the family member, such as hard or curriculum-1.5."""
    pedestrians: Annotated[int, Range(0, 1000)] = 5
    """Number of pedestrians."""
    obstacles: Annotated[int, Range(0, 1000)] = 5
    """Number of static, disc-shaped obstacles."""
    obstacle_radius_min: Annotated[float, Range(0.01, 100)] = 0.3
    """Smallest obstacle radius, m."""
    obstacle_radius_max: Annotated[float, Range(0.01, 100)] = 0.3
    """Largest obstacle radius, m."""
    hardest_obstacle_ratio: Annotated[float, Range(0, 1)] = 0.0
    """Share of the obstacles, rounded up, that have the largest radius."""
    layout: Annotated[str, OneOf(LAYOUTS)] = 'square_crossing'
    """
    square_crossing: sides are swapped; circle_crossing: everybody crosses a circle; open_square:
    the robot crosses a square without walls, people come from all around it; recorded: the robot
    goes between places where recorded people walked.
    """
    spawn_half_width: Annotated[float, Range(0.1, 1000)] = 5.0
    """Half the side of the spawn square and radius of the circle of goals, m."""
    circle_radius: Annotated[float, Range(0.1, 1000)] = 4.0
    """Radius of the circle that is crossed, or that people come from in open_square, m."""
    minimum_travel: Annotated[float, Range(0.01, 2000)] = 7.5
    """Least |goal - start| of the robot along one of the axes (open_square: itself), m."""
    maximum_travel: Annotated[float, Range(0.01, 2000, or_infinite=True)] = math.inf
    """Greatest |goal - start| of the robot along the longer axis (open_square: itself), m."""
    start_noise: Annotated[float, Range(0, 1000)] = 1.25
    """Half-width of the noise on the robot's start along each axis, m (square_crossing)."""
    bounds: Annotated[float, Range(0.1, 10_000, or_infinite=True)] = 7.5
    """Half-width of the square that must not be left, m; .inf for none."""
    renew_goals: bool = True
    """Whether a pedestrian that arrives gets another goal."""
    randomize_attributes: bool = False
    """Whether pedestrians have speeds of U(0.5, 1.5) m/s and radii of U(0.3, 0.5) m."""
    pedestrian_radius: Annotated[float, Range(0.01, 10)] = 0.3
    """Radius of a pedestrian, m."""
    pedestrian_speed: Annotated[float, Range(0, 10)] = 1.0
    """Preferred and maximum speed of a pedestrian, m/s; 0: all stand."""
    robot_radius: Annotated[float, Range(0.01, 10)] = 0.3
    """Radius of the robot, m."""
    robot_preferred_speed: Annotated[float, Range(0.01, 10)] = 1.0
    """Preferred and maximum speed of the robot, m/s."""
    robot_start: Annotated[tuple[float, float] | None, Point(FARTHEST)] = None
    """Where the robot begins, [x, y], m; null: drawn by the layout."""
    robot_goal: Annotated[tuple[float, float] | None, Point(FARTHEST)] = None
    """Where the robot shall arrive, [x, y], m; null: drawn by the layout."""
    robot_acceleration: Annotated[float, Range(0.001, 1000, or_infinite=True)] = math.inf
    """Largest change of the robot's velocity, of a differential drive: of its speed, m/s^2."""
    robot_turn_rate: Annotated[float, Range(0.001, 1000, or_infinite=True)] = math.inf
    """Largest turn rate of a differential drive, rad/s."""
    robot_angular_acceleration: Annotated[float, Range(0.001, 1000, or_infinite=True)] = math.inf
    """Largest change of the turn rate of a differential drive, rad/s^2."""
    robot_visible: bool = False
    """Whether pedestrians see the robot and avoid it."""
    kinematics: Annotated[str, OneOf(KINEMATICS)] = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    crowd: Annotated[str, OneOf(CROWDS)] = 'orca'
    """What moves the pedestrians: a name in CROWDS."""
    goal_tolerance: Annotated[float, Range(0.001, 5)] = 0.3
    """The goal is reached when the robot's centre is nearer than this, m."""
    time_step: Annotated[float, Range(0.01, 2)] = 0.25
    """Time between two decisions, s."""
    time_limit: Annotated[float, Range(0.01, 3600)] = 25.0
    """Episodes are truncated after this time, s."""
    orca: OrcaConfig = OrcaConfig()
    """How the pedestrians of the crowd orca move."""
    recording: RecordingConfig = RecordingConfig()
    """Who is in the world where the crowd is recorded."""
    reward: RewardConfig = RewardConfig()
    """What a step is worth."""

    def __post_init__(self) -> None:
        """Refuse values that describe no world."""
        require_allowed(self)
        require(
            self.obstacle_radius_min <= self.obstacle_radius_max,
            f'scenario {self.name}: obstacle_radius_min ({self.obstacle_radius_min}) must not be '
            f'above obstacle_radius_max ({self.obstacle_radius_max})',
        )
        require(
            self.minimum_travel < self.maximum_travel,
            f'scenario {self.name}: minimum_travel must be less than maximum_travel',
        )
        self._require_places()
        self._require_recording()

    def _require_recording(self) -> None:
        """Refuse recorded people without a file, and a file without recorded people."""
        recorded = self.crowd in RECORDED
        require(
            recorded == (self.layout == 'recorded') == bool(self.recording.file),
            f'scenario {self.name}: the crowds {" and ".join(RECORDED)} need the layout recorded '
            'and recording.file, and nothing else does; name the scenario recorded:FILE',
        )
        require(
            not (recorded and self.obstacles),
            f'scenario {self.name}: obstacles must be 0 among recorded people, whose own are not '
            'known',
        )
        require(
            not recorded or self.robot_visible == (self.crowd == 'recorded_reactive'),
            f'scenario {self.name}: robot_visible must be {str(not self.robot_visible).lower()} '
            f'with the crowd {self.crowd}',
        )

    def _require_places(self) -> None:
        """Refuse a chosen start or goal that the robot cannot be at."""
        for name in ('robot_start', 'robot_goal'):
            place, room = getattr(self, name), self.bounds - self.robot_radius
            require(
                place is None or max(map(abs, place)) <= room,
                f'scenario {self.name}: {name} {place} leaves the robot no room within the '
                f'bounds, {self.bounds:g} m',
            )
        if self.robot_start is not None and self.robot_goal is not None:
            require(
                math.dist(self.robot_start, self.robot_goal) >= self.goal_tolerance,
                f'scenario {self.name}: robot_start is within goal_tolerance of robot_goal',
            )

    @property
    def agents(self) -> int:
        """Return the number of agents: pedestrians first, then obstacles."""
        return self.pedestrians + self.obstacles

    @property
    def robot_matters(self) -> bool:
        """Return whether what pedestrians do can depend on where the robot is."""
        return self.robot_visible or self.crowd in ROBOT_MATTERS

    @property
    def discount(self) -> float:
        """Return the discount of one step."""
        return self.reward.discount ** (self.time_step * self.robot_preferred_speed)
