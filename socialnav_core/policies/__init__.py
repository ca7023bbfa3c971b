"""Policies: baselines, the search, value networks and the look-ahead that drives by them."""

from socialnav_core.policies.loading import load_policy
from socialnav_core.policies.orca import OrcaPolicy
from socialnav_core.policies.protocol import Policy, PolicyDescription
from socialnav_core.policies.search.search_policy import SearchPolicy
from socialnav_core.policies.straight_line import StraightLinePolicy
from socialnav_core.policies.value.checkpoint import build_network, CheckpointError
from socialnav_core.policies.value.gat4sn import Gat4snValueNetwork
from socialnav_core.policies.value.lookahead import ValuePolicy
from socialnav_core.policies.value.observation import observe
from socialnav_core.policies.value.sarl import SarlValueNetwork

__all__ = [
    'CheckpointError',
    'Gat4snValueNetwork',
    'OrcaPolicy',
    'Policy',
    'PolicyDescription',
    'SarlValueNetwork',
    'SearchPolicy',
    'StraightLinePolicy',
    'ValuePolicy',
    'build_network',
    'load_policy',
    'observe',
]
