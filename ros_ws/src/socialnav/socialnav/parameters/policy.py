"""Every parameter of the policy node, and what follows from them."""

import dataclasses
import math

from socialnav.messages.conversions import RobotBody
from socialnav.parameters import AUTO
from socialnav.parameters.fields import parameter
from socialnav_core.config import KINEMATICS
from socialnav_core.simulation.kinematics import Limits

STALL_SHARE = 0.8
"""Part of input_timeout by which a decision may be overdue."""


@dataclasses.dataclass(frozen=True)
class PolicyParameters:
    """What the policy node, its driver and its controller are told."""

    autostart: bool = parameter(
        True, 'configure and activate at start, without a lifecycle manager'
    )
    model: str = parameter(
        AUTO, 'name in the share folder, path, or a policy without network such as `search`; '
        'auto: `socialnav` for a holonomic base, `socialnav_diff_drive` for a differential one',
        live='inactive',
    )  # fmt: skip
    lookahead: str = parameter(
        'checkpoint', 'prediction of people; checkpoint: that of the model',
        choices=('checkpoint', 'constant_velocity', 'learned'), live='inactive',
    )  # fmt: skip
    screening: str = parameter(
        'checkpoint', 'refuse actions after which a collision is certain; checkpoint: as saved',
        choices=('checkpoint', 'enabled', 'disabled'), live='inactive',
    )  # fmt: skip
    screening_horizon: float = parameter(
        0.0, 'how long the way of escape must stay free; 0: as saved',
        's', (0.0, 10.0), live='inactive',
    )  # fmt: skip
    lockstep: bool = parameter(
        False, 'decide once per state of a simulator in lockstep', live='inactive'
    )
    scenario: str = parameter(
        'hard', 'world that gives radius, speed and bounds in lockstep', live='inactive'
    )
    controller_frequency: float = parameter(
        10.0, 'decisions per second', 'Hz', (1.0, 100.0), live='inactive'
    )
    input_timeout: float = parameter(
        0.5, 'age of odom or pedestrians at which the robot stops', 's', (0.05, 10.0), live='yes'
    )
    obstacles_timeout: float = parameter(
        0.0, 'age of obstacles at which the robot stops; 0: they do not age',
        's', (0.0, 3600.0), live='yes',
    )  # fmt: skip
    require_obstacles: bool = parameter(True, 'stand until obstacles have come', live='yes')
    use_map: bool = parameter(
        False, 'occupied cells of the map near the robot are obstacles; stand without',
        live='inactive',
    )  # fmt: skip
    plan_lookahead_distance: float = parameter(
        2.0, 'way along a plan to the point that is headed for', 'm', (0.1, 100.0), live='yes'
    )
    plan_timeout: float = parameter(
        0.0, 'age of a plan at which the goal itself is headed for; 0: never',
        's', (0.0, 3600.0), live='yes',
    )  # fmt: skip
    stop_publish_timeout: float = parameter(
        10.0, 'go silent after nothing but stops for so long; 0: never',
        's', (0.0, 3600.0), live='yes',
    )  # fmt: skip
    bounds: float = parameter(
        math.inf, 'half-width of the square around the origin not to be left; .inf: none',
        'm', (0.1, math.inf), live='yes',
    )  # fmt: skip
    robot_radius: float = parameter(0.3, 'radius of the robot', 'm', (0.05, 5.0), live='yes')
    preferred_speed: float = parameter(1.0, 'speed to drive at', 'm/s', (0.05, 5.0), live='yes')
    kinematics: str = parameter(
        'holonomic', 'how the robot moves', choices=KINEMATICS, live='inactive'
    )
    reverse: float = parameter(
        0.0, 'largest speed backwards of a differential base, as a share of preferred_speed, for '
        'a base whose sensors see behind; 0: never',
        '', (0.0, 1.0), live='inactive',
    )  # fmt: skip
    max_speed: float = parameter(1.0, 'no command is faster', 'm/s', (0.0, 5.0), live='yes')
    max_acceleration: float = parameter(
        math.inf, 'no command changes the velocity faster; .inf: no limit',
        'm/s^2', (0.01, math.inf), live='yes',
    )  # fmt: skip
    max_turn_rate: float = parameter(
        math.pi, 'no command turns faster', 'rad/s', (0.0, 20.0), live='yes'
    )
    max_angular_acceleration: float = parameter(
        math.inf, 'no command changes the turn rate faster; .inf: no limit',
        'rad/s^2', (0.01, math.inf), live='yes',
    )  # fmt: skip
    goal_tolerance: float = parameter(
        0.3, 'distance to the goal at which it is reached', 'm', (0.01, 5.0), live='yes'
    )
    goal_yaw_tolerance: float = parameter(
        math.inf, 'angle to the heading of the goal at which it is reached, by turning on the '
        'spot at the end; .inf: any heading will do',
        'rad', (0.01, math.inf), live='yes',
    )  # fmt: skip
    progress_distance: float = parameter(
        0.5, 'coming nearer to the goal, or along the plan, by so much is progress',
        'm', (0.01, 10.0), live='yes',
    )  # fmt: skip
    progress_timeout: float = parameter(
        10.0, 'time of driving without progress after which that is said; 0: never',
        's', (0.0, 3600.0), live='yes',
    )  # fmt: skip
    progress_stop_timeout: float = parameter(
        30.0, 'time of driving without progress after which the robot stops; 0: never',
        's', (0.0, 3600.0), live='yes',
    )  # fmt: skip
    failure_tolerance: float = parameter(
        0.3, 'time without a command after which follow_path fails; 0: at once, -1: never',
        's', (-1.0, 3600.0), live='yes',
    )  # fmt: skip
    controller_id: str = parameter(
        'FollowPath', 'name that follow_path is called with', live='yes'
    )
    goal_checker_id: str = parameter(
        'general_goal_checker', 'name of the only check of goals', live='yes'
    )
    progress_checker_id: str = parameter(
        'progress_checker', 'name of the only check of progress', live='yes'
    )
    goal_topics: bool = parameter(
        True, 'heed goal_pose and plan; false: only follow_path gives goals', live='inactive'
    )
    max_agents: int = parameter(
        20, 'only the nearest so many agents count', '', (1, 1000), live='yes'
    )
    planning_frame: str = parameter(
        'odom', 'frame of decisions; inputs in others need tf2_ros', live='inactive'
    )
    base_frame: str = parameter(
        'base_link', 'frame of the robot: of the twist in odom, and of stamped commands',
        live='inactive',
    )  # fmt: skip
    enable_stamped_cmd_vel: bool = parameter(
        False, 'TwistStamped instead of Twist; lockstep always does', live='inactive'
    )
    device: str = parameter(
        'cpu', 'where the network is computed', choices=('cpu', 'cuda'), live='inactive'
    )
    threads: int = parameter(1, 'threads of a decision', '', (1, 64), live='inactive')

    @property
    def period(self) -> float:
        """Return the time between two decisions, s."""
        return 1 / self.controller_frequency

    @property
    def stall_timeout(self) -> float:
        """
        Return the time without a decision after which something must be wrong, s.

        It ends before input_timeout and a period are over, for the stop must be heard by then.
        """
        return self.period + STALL_SHARE * self.input_timeout

    @property
    def body(self) -> RobotBody:
        """Return the robot itself."""
        return RobotBody(self.robot_radius, self.preferred_speed, self.bounds)

    @property
    def limits(self) -> Limits:
        """Return what the robot can do."""
        return Limits(
            self.max_speed, self.max_acceleration, self.max_turn_rate, self.period,
            self.max_angular_acceleration,
        )  # fmt: skip

    @property
    def stamped(self) -> bool:
        """Return whether commands are TwistStamped."""
        return self.lockstep or self.enable_stamped_cmd_vel
