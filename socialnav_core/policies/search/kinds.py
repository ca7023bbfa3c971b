"""The search for each kind of robot."""

import dataclasses

from socialnav_core.config import Scenario, SearchConfig
from socialnav_core.policies.search.differential.policy import DifferentialSearchPolicy
from socialnav_core.policies.search.search_policy import SearchPolicy
from socialnav_core.policies.search.terminal import Valuation

AnySearchPolicy = SearchPolicy | DifferentialSearchPolicy


def search_policy(
    settings: SearchConfig, value: Valuation | None = None, name: str = 'search'
) -> AnySearchPolicy:
    """
    Return the search for the robot that the settings name.

    :param value: what the ways on are worth at the horizon, None: nothing but their length.
    :param name: what results call it.
    """
    kinds = {kind.kinematics: kind for kind in (SearchPolicy, DifferentialSearchPolicy)}
    return kinds[settings.kinematics](settings, value=value, name=name)


def with_base(scenario: Scenario, policy: SearchConfig) -> Scenario:
    """Return a world with the base that a policy drives, a differential drive with its limits."""
    if policy.kinematics != 'differential' or scenario.kinematics == 'differential':
        return scenario
    base = policy.differential
    return dataclasses.replace(
        scenario,
        kinematics=policy.kinematics,
        robot_acceleration=base.acceleration,
        robot_turn_rate=base.turn_rate,
        robot_angular_acceleration=base.angular_acceleration,
    )
