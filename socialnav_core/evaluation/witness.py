"""A robot that drives the path that the clairvoyant search found."""

import numpy as np

from socialnav_core.config import BoundConfig, ConfigError, Scenario
from socialnav_core.evaluation.bound import find_path
from socialnav_core.evaluation.futures import record_futures
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState

WITNESS = 'bound'
"""What it is called where policies are chosen by name."""


class WitnessPolicy:
    """Follows a path, a position a step; it belongs to one case."""

    predictor = None
    plan = None
    description = PolicyDescription(WITNESS, 'holonomic', 'future', 'oracle')

    def __init__(self, path: np.ndarray, time_step: float) -> None:
        """
        Choose what to follow.

        :param path: m, (steps + 1, 2).
        """
        self._velocity = np.diff(path, axis=0) / time_step
        self._time_step = time_step

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the commands, (batch, 2)."""
        return self._velocity[np.rint(state.time / self._time_step).astype(int)]

    def attention(self, state: CrowdState) -> None:
        """Return nothing: it knows."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Do nothing: there is no memory."""


def witness_of(
    scenario: Scenario, case: int, seed: int = 0, split: str = 'test', gap: float | None = None
) -> WitnessPolicy:
    """
    Return the robot that drives a case as fast as it can be driven.

    :param gap: to people that it keeps, m; None for the comfort distance.
    :raises ConfigError: when people react to the robot, or no path was found.
    """
    config = BoundConfig()
    gap = config.comfort_distance if gap is None else gap
    path = find_path(record_futures(scenario, np.array([case]), seed, split), 0, gap, config)
    if path is None:
        raise ConfigError(
            f'no path that keeps {gap:g} m of people was found for case {case} of {scenario.name} '
            f'within {scenario.time_limit:g} s'
        )
    return WitnessPolicy(path, scenario.time_step)
