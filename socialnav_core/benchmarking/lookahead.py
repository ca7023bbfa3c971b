"""How long one decision takes."""

import time
from typing import Any

import numpy as np
import torch
from torch import nn

from socialnav_core.benchmarking.measurement import in_turns, Measurement
from socialnav_core.config import PolicyConfig, Scenario
from socialnav_core.policies import build_network, ValuePolicy
from socialnav_core.prediction import PREDICTIONS
from socialnav_core.prediction.oracle import attach_simulator
from socialnav_core.simulation import Simulator

REPEATS, REFERENCE_REPEATS, WARM_UP = 200, 5, 20
ROUNDS = 5
NETWORKS = {'sarl': 'SARL', 'gat4sn': 'GAT4SN (4)'}
SETTINGS = ((10, 2, 8), (20, 5, 16))
"""Pedestrians, speeds and headings."""


def lookahead_measurements(reference: Any) -> list[Measurement]:
    """
    Return milliseconds per decision of a single robot, screening off.

    :param reference: the plain reference, or None.
    """
    return [
        decision(network, *setting, lookahead, reference)
        for setting in SETTINGS
        for lookahead in PREDICTIONS
        for network in NETWORKS
    ]


def decision(
    name: str, pedestrians: int, speeds: int, headings: int, lookahead: str, reference: Any
) -> Measurement:
    """
    Return how long a decision takes, its median and its 99th percentile.

    :param name: key of NETWORKS.
    :param lookahead: prediction of the pedestrians; the oracle's time is part of the decision.
    """
    config = PolicyConfig(network=name, speeds=speeds, headings=headings, lookahead=lookahead)
    torch.manual_seed(0)
    network = build_network(config).eval()
    times: list[np.ndarray] = []

    def rate() -> float:
        times.append(decision_seconds(network, config, pedestrians))
        return 1 / float(np.median(times[-1]))

    def plain_rate() -> float:
        actions = reference.action_set(speeds, headings)
        seconds = reference.reference_decision_seconds(
            network, actions, pedestrians, REFERENCE_REPEATS, lookahead == 'oracle'
        )
        return 1 / float(np.median(seconds))

    value, plain, ratio = in_turns(rate, plain_rate if reference else None, ROUNDS)
    actions = speeds * headings + 1
    return Measurement(
        f'{NETWORKS[name]}, {actions} actions, {pedestrians} agents, {lookahead}',
        1000 / value,
        'ms',
        reference=1000 / plain if plain else None,
        ratio=ratio,
        details={'p99_milliseconds': 1000 * float(np.quantile(np.concatenate(times), 0.99))},
    )


def decision_seconds(network: nn.Module, config: PolicyConfig, pedestrians: int) -> np.ndarray:
    """Return how long each of some decisions took, one episode after the other, s, (REPEATS,)."""
    simulator = Simulator(Scenario('benchmark', pedestrians=pedestrians, obstacles=0))
    policy, state = ValuePolicy(network, config), simulator.reset()
    attach_simulator(policy.predictor, simulator.next_agent_velocities)
    seconds = np.empty(WARM_UP + REPEATS)
    for i in range(len(seconds)):
        started = time.perf_counter()
        command = policy.act(state)
        seconds[i] = time.perf_counter() - started
        state = simulator.step(command)[0]
    return seconds[WARM_UP:]
