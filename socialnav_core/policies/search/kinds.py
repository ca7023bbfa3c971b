"""The search for each kind of robot."""

from socialnav_core.config import SearchConfig
from socialnav_core.policies.search.differential.policy import DifferentialSearchPolicy
from socialnav_core.policies.search.search_policy import SearchPolicy


def search_policy(settings: SearchConfig) -> SearchPolicy | DifferentialSearchPolicy:
    """Return the search for the robot that the settings name."""
    kinds = {kind.kinematics: kind for kind in (SearchPolicy, DifferentialSearchPolicy)}
    return kinds[settings.kinematics](settings)
