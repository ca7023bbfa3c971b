"""What the controller must know about robot, inputs and time."""

import dataclasses
import math
from typing import Any

from socialnav.messages.conversions import RobotBody
from socialnav_core.config import Scenario
from socialnav_core.simulation import resolve_scenario
from socialnav_core.simulation.kinematics import Limits

STALL_SHARE = 0.8
"""Part of input_timeout by which a decision may be overdue."""


@dataclasses.dataclass(frozen=True)
class ControllerSettings:
    """Settings of a controller; units as in the table of parameters."""

    body: RobotBody
    """The robot itself."""
    limits: Limits
    """What it can do."""
    kinematics: str
    """holonomic or differential."""
    goal_tolerance: float
    """Distance to the goal at which it is reached, m."""
    period: float
    """Time between two decisions, s."""
    max_agents: int = 20
    """Only the nearest so many agents are looked at."""
    planning_frame: str = 'odom'
    """Frame that all inputs must be in."""
    input_timeout: float = 0.5
    """Age of odom or pedestrians at which the robot stops, s."""
    obstacles_timeout: float = 0.0
    """Age of obstacles at which the robot stops, s; 0 for never."""
    require_obstacles: bool = False
    """Whether the robot stands until obstacles have come."""
    stop_publish_timeout: float = 10.0
    """Time of nothing but stops after which nothing is published, s; 0 for never."""
    use_map: bool = False
    """Whether occupied cells of the map are obstacles."""
    plan_lookahead_distance: float = 2.0
    """Way along a plan from the robot to the point that it heads for, m."""
    plan_timeout: float = 0.0
    """Age of a plan at which it is not followed any more, s; 0 for never."""
    lockstep: bool = False
    """Whether the world waits for each decision."""

    @property
    def stall_timeout(self) -> float:
        """
        Return the time without a decision after which something must be wrong, s.

        It ends before input_timeout and a period are over, for the stop must be heard by then.
        """
        return self.period + STALL_SHARE * self.input_timeout


def controller_settings(values: dict[str, Any]) -> ControllerSettings:
    """
    Return the settings that the parameters ask for.

    :param values: all parameters of the policy node.
    :raises ConfigError: a scenario that does not exist.
    """
    if not values['lockstep']:
        return real_time_settings(values)
    wanted = {'name': values['scenario'], 'kinematics': values['kinematics']}
    return lockstep_settings(values, resolve_scenario(wanted))


def real_time_settings(values: dict[str, Any]) -> ControllerSettings:
    """
    Return the settings of a robot in the real world.

    :param values: all parameters of the policy node.
    """
    same_name = (
        'kinematics', 'goal_tolerance', 'max_agents', 'planning_frame', 'input_timeout',
        'obstacles_timeout', 'require_obstacles', 'stop_publish_timeout', 'use_map',
        'plan_lookahead_distance', 'plan_timeout',
    )  # fmt: skip
    limits = (values[name] for name in ('max_speed', 'max_acceleration', 'max_turn_rate'))
    period = 1 / values['controller_frequency']
    return ControllerSettings(
        body=RobotBody(values['robot_radius'], values['preferred_speed'], values['bounds']),
        limits=Limits(*limits, period),
        period=period,
        **{name: values[name] for name in same_name},
    )


def lockstep_settings(values: dict[str, Any], scenario: Scenario) -> ControllerSettings:
    """
    Return the settings with which a decision is the same as in the simulator alone.

    :param values: all parameters of the policy node.
    :param scenario: the world that is simulated.
    """
    speed = scenario.robot_preferred_speed
    return ControllerSettings(
        body=RobotBody(scenario.robot_radius, speed, scenario.bounds),
        limits=Limits(speed, math.inf, math.inf, scenario.time_step),
        kinematics=scenario.kinematics,
        goal_tolerance=scenario.goal_tolerance,
        period=scenario.time_step,
        max_agents=max(values['max_agents'], scenario.agents),
        planning_frame=values['planning_frame'],
        stop_publish_timeout=0.0,
        lockstep=True,
    )
