"""How long one decision takes."""

import dataclasses
from typing import Any

import numpy as np
import torch

from socialnav_core.benchmarking.measurement import call_times, in_turns, Measurement
from socialnav_core.config import PolicyConfig
from socialnav_core.policies import build_network, ValuePolicy
from socialnav_core.simulation import make_scenario, Simulator

REPEATS = 300
ROUNDS = 3
NETWORKS = {'sarl': 'SARL', 'gat4sn': 'GAT4SN, 4 heads'}
SETTINGS = {
    '17 actions, 10 agents': ('simple', 2, 8),
    '81 actions, 20 agents': ('crowd20', 5, 16),
}
"""Scenario, speeds and headings of each setting."""


def lookahead_measurements(reference: Any) -> list[Measurement]:
    """
    Return milliseconds per decision for a single robot, screening off.

    :param reference: the plain reference, or None.
    """
    return [decision(network, setting, reference) for setting in SETTINGS for network in NETWORKS]


def decision(network: str, setting: str, reference: Any) -> Measurement:
    """
    Return how long a decision takes, its median and its 99th percentile.

    :param network: key of NETWORKS.
    :param setting: key of SETTINGS.
    :param reference: the plain reference, or None.
    """
    scenario, speeds, headings = SETTINGS[setting]
    config = PolicyConfig(network=network, speeds=speeds, headings=headings)
    simulator = Simulator(make_scenario(scenario))
    state = simulator.reset()
    torch.manual_seed(0)
    policy = ValuePolicy(build_network(config), config)
    times: list[np.ndarray] = []

    def rate() -> float:
        times.append(call_times(lambda: policy.act(state), REPEATS))
        return 1 / float(np.median(times[-1]))

    def plain_rate() -> float:
        return 1 / float(np.median(reference.decision_times(network, config, state)))

    value, plain, ratio = in_turns(rate, plain_rate if reference else None, ROUNDS)
    p99 = 1000 * float(np.quantile(np.concatenate(times), 0.99))
    return dataclasses.replace(
        Measurement(f'decision, {NETWORKS[network]}, {setting}', 1000 / value, 'ms'),
        reference=1000 / plain if plain else None,
        ratio=ratio,
        details={'p99_milliseconds': p99},
    )
