"""The parameters of the policy node as they count for the controller, in either mode of time."""

import dataclasses

from socialnav.parameters.policy import PolicyParameters
from socialnav_core.config import Scenario
from socialnav_core.simulation import resolve_scenario


def controller_settings(parameters: PolicyParameters) -> PolicyParameters:
    """
    Return what the controller goes by.

    :raises ConfigError: a scenario that does not exist.
    """
    if not parameters.lockstep:
        return parameters
    wanted = {'name': parameters.scenario, 'kinematics': parameters.kinematics}
    return lockstep_settings(parameters, resolve_scenario(wanted))


def lockstep_settings(parameters: PolicyParameters, scenario: Scenario) -> PolicyParameters:
    """Return the settings with which a decision is the same as in the simulator alone."""
    speed = scenario.robot_preferred_speed
    return dataclasses.replace(
        parameters,
        robot_radius=scenario.robot_radius,
        preferred_speed=speed,
        bounds=scenario.bounds,
        max_speed=speed,
        max_acceleration=scenario.robot_acceleration,
        max_turn_rate=scenario.robot_turn_rate,
        max_angular_acceleration=scenario.robot_angular_acceleration,
        kinematics=scenario.kinematics,
        goal_tolerance=scenario.goal_tolerance,
        controller_frequency=1 / scenario.time_step,
        max_agents=max(parameters.max_agents, scenario.agents),
        require_obstacles=False,
        use_map=False,
        obstacles_timeout=0.0,
        plan_timeout=0.0,
        stop_publish_timeout=0.0,
    )
