"""Policies: baselines, value networks and the look-ahead that drives by them."""

from socialnav_core.policies.base import load_policy, Policy
from socialnav_core.policies.checkpoint import build_network, CheckpointError
from socialnav_core.policies.gat4sn import Gat4snValueNetwork
from socialnav_core.policies.lookahead import ValuePolicy
from socialnav_core.policies.orca_policy import OrcaPolicy
from socialnav_core.policies.sarl import SarlValueNetwork
from socialnav_core.policies.straight_line import StraightLinePolicy

__all__ = [
    'CheckpointError',
    'Gat4snValueNetwork',
    'OrcaPolicy',
    'Policy',
    'SarlValueNetwork',
    'StraightLinePolicy',
    'ValuePolicy',
    'build_network',
    'load_policy',
]
