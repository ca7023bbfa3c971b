"""Laws of what follows from the parameters of the policy node; no middleware is needed."""

import math
from pathlib import Path

import pytest

from socialnav.control.settings import controller_settings
from socialnav.messages.conversions import RobotBody
from socialnav.parameters.fields import same_but_live
from socialnav.parameters.policy import PolicyParameters
from socialnav_core.config import SCENARIOS
from socialnav_core.simulation import make_scenario
from socialnav_core.simulation.kinematics import Limits

RECORDED_PEOPLE = Path(__file__).parents[5] / 'tests' / 'data' / 'recorded_people.txt'


def test_in_real_time_the_parameters_count_as_they_are():
    parameters = PolicyParameters(
        robot_radius=0.4, preferred_speed=0.8, bounds=9.0, max_speed=0.9, max_acceleration=1.1,
        max_turn_rate=1.2, controller_frequency=5.0,
    )  # fmt: skip
    settings = controller_settings(parameters)
    assert settings is parameters
    assert settings.body == RobotBody(0.4, 0.8, 9.0)
    assert settings.limits == Limits(0.9, 1.1, 1.2, 0.2)
    assert not settings.stamped


@pytest.mark.parametrize('name', [
    name.replace('-R', '-1.5').replace('FILE', str(RECORDED_PEOPLE)) for name in SCENARIOS
])  # fmt: skip
def test_in_lockstep_robot_and_time_are_those_of_the_scenario(name):
    scenario = make_scenario(name)
    settings = controller_settings(
        PolicyParameters(
            lockstep=True,
            scenario=name,
            robot_radius=4.0,
            max_speed=0.1,
            max_acceleration=0.1,
            controller_frequency=7.0,
            goal_tolerance=2.0,
            use_map=True,
            require_obstacles=True,
            planning_frame='world',
            base_frame='foot',
        )  # fmt: skip
    )
    speed = scenario.robot_preferred_speed
    assert settings.body == RobotBody(scenario.robot_radius, speed, scenario.bounds)
    assert settings.limits == Limits(speed, math.inf, math.inf, scenario.time_step)
    assert settings.period == scenario.time_step
    assert settings.goal_tolerance == scenario.goal_tolerance
    assert settings.max_agents >= scenario.agents
    assert settings.stamped and not settings.use_map and not settings.require_obstacles
    assert (settings.planning_frame, settings.base_frame) == ('world', 'foot')


def test_settings_differ_for_a_driver_only_in_what_cannot_change_while_it_drives():
    parameters = PolicyParameters()
    assert same_but_live(parameters, PolicyParameters(max_speed=0.1, bounds=3.0))
    assert not same_but_live(parameters, PolicyParameters(planning_frame='world'))
    assert not same_but_live(parameters, PolicyParameters(autostart=False))
