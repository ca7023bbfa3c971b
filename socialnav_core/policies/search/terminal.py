"""A value network at the horizon of the search."""

import dataclasses
from typing import Protocol

import numpy as np
from torch import nn

from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.observation import HOLONOMIC, observe
from socialnav_core.prediction import Prediction
from socialnav_core.simulation.kinematics import DifferentialDrive, Kinematics
from socialnav_core.simulation.kinematics.angles import direction
from socialnav_core.states import CrowdState, Observation

DIFFERENTIAL = DifferentialDrive()
AGENTS = 20
"""The network sees the nearest so many people and obstacles."""


@dataclasses.dataclass(frozen=True)
class Horizon:
    """What the search knows of the moment that it looks up to."""

    state: CrowdState
    """The worlds as they are."""
    prediction: Prediction
    """Of their agents, up to the horizon."""
    last_layer: float
    """Duration of the last step of the prediction, s."""
    positions: np.ndarray
    """Where the robot may be then, m, (batch, candidates, 2)."""
    subgoals: np.ndarray
    """Goals in sight from there, as far as the way to the goal, m, (batch, candidates, 2)."""
    used: np.ndarray
    """Which candidates there are, bool, (batch, candidates)."""
    headings: np.ndarray | None = None
    """Where the robot looks then, rad, (batch, candidates); None for one that looks nowhere."""
    speeds: np.ndarray | None = None
    """How fast it drives there, m/s, (batch, candidates); None where it may stand as well."""


class Valuation(Protocol):
    """Weighs the candidates of a search."""

    def costs(self, horizon: Horizon) -> np.ndarray:
        """Return what each costs beyond its way to the goal, s, (batch, candidates)."""
        ...

    def attention(self, state: CrowdState) -> np.ndarray | None:
        """Return how much it looks at each agent, summing to 1, (batch, agents), if it tells."""
        ...


class TerminalValue:
    """Tells what each candidate of a search costs beyond its way to the goal."""

    def __init__(self, network: nn.Module, kinematics: Kinematics = HOLONOMIC) -> None:
        """
        Keep a value network whose value is such a cost, s.

        :param kinematics: of the robot that it sees.
        """
        self.network = network
        self._kinematics = kinematics
        self._inference = ValueInference(network)

    def costs(self, horizon: Horizon) -> np.ndarray:
        """Return the cost of each candidate, s, (batch, candidates); 0 where there is none."""
        costs = np.zeros(horizon.used.shape)
        seen = observe_horizon(horizon)
        if len(seen.mask):
            costs[horizon.used] = self._inference.values(seen.robot, seen.others, seen.mask)
        return costs

    def attention(self, state: CrowdState) -> np.ndarray:
        """Return how much the network looks at each agent of a state, (batch, agents)."""
        return self._inference.attention(observe(state, self._kinematics))


def observe_horizon(horizon: Horizon) -> Observation:
    """Return what the network sees of each candidate that is used, world after world."""
    worlds, places = np.nonzero(horizon.used)
    positions = horizon.positions[worlds, places]
    subgoals = horizon.subgoals[worlds, places]
    expected = expected_state(horizon.state, horizon.prediction, horizon.last_layer)
    if horizon.headings is None or horizon.speeds is None:
        return observe_robots(expected.select(worlds), positions, subgoals)
    headings, speeds = horizon.headings[worlds, places], horizon.speeds[worlds, places]
    return observe_drives(expected.select(worlds), positions, subgoals, headings, speeds)


def observe_robots(state: CrowdState, positions: np.ndarray, goals: np.ndarray) -> Observation:
    """
    Return what the network sees where robots stand elsewhere with other goals.

    :param positions: m, (batch, 2).
    :param goals: m, (batch, 2).
    """
    standing = np.zeros_like(positions)
    placed = state.with_robot(position=positions, velocity=standing, goal=goals)
    return observe(placed.nearest(AGENTS))


def observe_drives(
    state: CrowdState,
    positions: np.ndarray,
    goals: np.ndarray,
    headings: np.ndarray,
    speeds: np.ndarray,
) -> Observation:
    """
    Return the same of differential drives, for which it matters where they look and drive.

    :param headings: rad, (batch,).
    :param speeds: m/s, (batch,).
    """
    placed = state.with_robot(
        position=positions, velocity=speeds[:, None] * direction(headings), goal=goals,
        heading=headings,
    )  # fmt: skip
    return observe(placed.nearest(AGENTS), DIFFERENTIAL)


def expected_state(state: CrowdState, prediction: Prediction, last_layer: float) -> CrowdState:
    """Return a state with the agents where the likeliest mode of a prediction ends."""
    worlds, likeliest = np.arange(state.batch_size), prediction.weights.argmax(axis=1)
    positions = prediction.positions[worlds, likeliest]  # (batch, steps, agents, 2)
    before = positions[:, -2] if positions.shape[1] > 1 else state.agents.position
    velocity = (positions[:, -1] - before) / last_layer
    velocity[state.agents.static] = 0.0
    return state.with_agents(position=positions[:, -1], velocity=velocity)
