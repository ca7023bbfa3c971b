"""The search for each kind of robot."""

from socialnav_core.config import SearchConfig
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
