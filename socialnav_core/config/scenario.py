"""Settings of a world: who is in it, how people move, what a step is worth."""

import dataclasses
import math

from socialnav_core.config.mapping import require, require_choice

KINEMATICS = ('holonomic', 'differential')
CROWDS = {
    'orca': 'people avoid each other and obstacles, each doing its share',
    'non_reactive': 'people walk straight to their goals and react to nobody',
    'social_force': 'people push each other away, as in the social force model',
    'changing': 'as orca, but people change their goals, and new ones come for those who arrive',
}
"""What moves the people, by the names of the files in simulation/crowds."""
ROBOT_MATTERS = ('changing',)
"""Crowds in which nobody appears where the robot is."""
LAYOUTS = ('square_crossing', 'circle_crossing', 'open_square')
POSITIVE_SCENARIO_FIELDS = (
    'spawn_half_width', 'circle_radius', 'minimum_travel', 'maximum_travel', 'bounds',
    'pedestrian_radius', 'pedestrian_speed', 'robot_radius', 'robot_preferred_speed',
    'goal_tolerance', 'time_step', 'time_limit',
)  # fmt: skip


@dataclasses.dataclass(frozen=True)
class OrcaConfig:
    """Optimal reciprocal collision avoidance (van den Berg et al. 2011)."""

    neighbor_distance: float = 10.0
    """Agents whose centres are farther than this are ignored, m."""
    max_neighbors: int = 10
    """The nearest so many agents, by centre distance, are avoided."""
    time_horizon: float = 5.0
    """Collisions within this time are avoided, s."""
    safety_space: float = 0.0
    """Added to every radius, m, besides the constant 0.01 m."""
    static_responsibility: float = 0.5
    """Share of a conflict with an obstacle that the mover takes; 1 solves it alone."""


@dataclasses.dataclass(frozen=True)
class RewardConfig:
    """Reward of one step; terms as in CrowdNav and in the founding report."""

    goal: float = 1.0
    """For a step that ends at the goal."""
    collision: float = -0.25
    """For a step in which the robot touches a pedestrian or an obstacle."""
    out_of_bounds: float = -0.25
    """For a step that ends outside of the walls."""
    discomfort_distance: float = 0.2
    """Clearance below which a step is penalised, m."""
    discomfort_factor: float = 0.5
    """Penalty per metre of missing clearance and per second."""
    walls_discomfort: bool = True
    """Whether clearance to the walls counts for discomfort."""
    discount: float = 0.9
    """Discount per metre at preferred speed: gamma ** (time_step * preferred_speed) per step."""


@dataclasses.dataclass(frozen=True)
class Scenario:
    """A world: who is in it, how an episode starts and when it ends."""

    name: str
    """Name of the family member, such as hard or curriculum-1.5."""
    pedestrians: int = 5
    """Number of pedestrians."""
    obstacles: int = 5
    """Number of static, disc-shaped obstacles."""
    obstacle_radius_min: float = 0.3
    """Smallest obstacle radius, m."""
    obstacle_radius_max: float = 0.3
    """Largest obstacle radius, m."""
    hardest_obstacle_ratio: float = 0.0
    """Share of the obstacles, rounded up, that have the largest radius."""
    layout: str = 'square_crossing'
    """
    square_crossing: sides are swapped; circle_crossing: everybody crosses a circle; open_square:
    the robot crosses a square without walls, people come from all around it.
    """
    spawn_half_width: float = 5.0
    """Half the side of the spawn square and radius of the circle of goals, m."""
    circle_radius: float = 4.0
    """Radius of the circle that is crossed, or that people come from in open_square, m."""
    minimum_travel: float = 7.5
    """Least |goal - start| of the robot along one of the axes (open_square: itself), m."""
    maximum_travel: float = math.inf
    """Greatest |goal - start| of the robot along the longer axis (open_square: itself), m."""
    start_noise: float = 1.25
    """Half-width of the noise on the robot's start along each axis, m (square_crossing)."""
    bounds: float = 7.5
    """Half-width of the square that must not be left, m; .inf for none."""
    renew_goals: bool = True
    """Whether a pedestrian that arrives gets another goal."""
    randomize_attributes: bool = False
    """Whether pedestrians have speeds of U(0.5, 1.5) m/s and radii of U(0.3, 0.5) m."""
    pedestrian_radius: float = 0.3
    """Radius of a pedestrian, m."""
    pedestrian_speed: float = 1.0
    """Preferred and maximum speed of a pedestrian, m/s."""
    robot_radius: float = 0.3
    """Radius of the robot, m."""
    robot_preferred_speed: float = 1.0
    """Preferred and maximum speed of the robot, m/s."""
    robot_visible: bool = False
    """Whether pedestrians see the robot and avoid it."""
    kinematics: str = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    crowd: str = 'orca'
    """What moves the pedestrians: a name in CROWDS."""
    goal_tolerance: float = 0.3
    """The goal is reached when the robot's centre is nearer than this, m."""
    time_step: float = 0.25
    """Time between two decisions, s."""
    time_limit: float = 25.0
    """Episodes are truncated after this time, s."""
    orca: OrcaConfig = OrcaConfig()
    """How the pedestrians of the crowd orca move."""
    reward: RewardConfig = RewardConfig()
    """What a step is worth."""

    def __post_init__(self) -> None:
        """Refuse values that describe no world."""
        require(
            self.pedestrians >= 0 and self.obstacles >= 0, 'scenario: negative count of agents'
        )
        require(
            0 < self.obstacle_radius_min <= self.obstacle_radius_max,
            f'scenario {self.name}: obstacle radii must satisfy 0 < obstacle_radius_min '
            f'({self.obstacle_radius_min}) <= obstacle_radius_max ({self.obstacle_radius_max})',
        )
        require(0 <= self.hardest_obstacle_ratio <= 1, 'hardest_obstacle_ratio must lie in [0, 1]')
        require_choice('layout', self.layout, LAYOUTS)
        require_choice('kinematics', self.kinematics, KINEMATICS)
        require_choice('crowd', self.crowd, CROWDS)
        for name in POSITIVE_SCENARIO_FIELDS:
            require(getattr(self, name) > 0, f'scenario {self.name}: {name} must be positive')
        require(
            self.minimum_travel < self.maximum_travel,
            f'scenario {self.name}: minimum_travel must be less than maximum_travel',
        )
        require(self.start_noise >= 0, 'scenario: start_noise must not be negative')

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
