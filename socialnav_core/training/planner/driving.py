"""The search drives through worlds, and what it met becomes examples."""

import collections
import dataclasses
from typing import NamedTuple

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.config.planner import PlannerTrainingConfig
from socialnav_core.policies.search.kinds import AnySearchPolicy
from socialnav_core.policies.search.terminal import (
    AGENTS,
    expected_state,
    Horizon,
    observe_drives,
    observe_robots,
    Valuation,
)
from socialnav_core.simulation import Outcome, Simulator
from socialnav_core.simulation.kinematics import DifferentialDrive, Limits, limits_of
from socialnav_core.states import CrowdState, Observation

COLLISIONS = (Outcome.COLLISION_PEDESTRIAN, Outcome.COLLISION_OBSTACLE, Outcome.OUT_OF_BOUNDS)
NEW_PREFERENCE = 0.05
"""Probability that a step draws another preference."""


@dataclasses.dataclass
class Examples:
    """Moments as they were expected, and what they turned out to cost beyond the way."""

    observation: Observation
    """What the network sees, (examples, ...), AGENTS slots for agents."""
    cost: np.ndarray
    """Cost to go less the time that the distance takes, s, float32 (examples,)."""

    @staticmethod
    def concatenate(parts: 'list[Examples]') -> 'Examples':
        """Return the examples of all parts."""
        observation = Observation.concatenate([part.observation for part in parts])
        return Examples(observation, np.concatenate([part.cost for part in parts]))


class Drive(NamedTuple):
    """What came of some episodes."""

    examples: Examples
    """Empty where none were wanted."""
    outcome: np.ndarray
    """Codes of Outcome, (episodes,)."""
    time: np.ndarray
    """When each ended, s, (episodes,)."""
    intrusion: np.ndarray
    """Time nearer to somebody than the comfort distance, s, (episodes,)."""
    lost: np.ndarray
    """Costs beyond the time that the way takes where nobody is in it, s, (episodes,)."""


class Preference:
    """A value that adds a random preference for a direction, so that other ways are tried."""

    def __init__(
        self,
        value: Valuation | None,
        amplitude: float,
        worlds: int,
        generator: np.random.Generator,
    ) -> None:
        """
        Draw a preference for each world.

        :param value: what it is added to; None: nothing.
        :param amplitude: standard deviation along each axis, s/m.
        """
        self._value, self._amplitude, self._generator = value, amplitude, generator
        self._slope = generator.normal(0.0, amplitude, (worlds, 2))

    def costs(self, horizon: Horizon) -> np.ndarray:
        """Return the costs of the candidates, s, (batch, candidates)."""
        again = self._generator.random(len(self._slope)) < NEW_PREFERENCE
        drawn = self._generator.normal(0.0, self._amplitude, self._slope.shape)
        self._slope = np.where(again[:, None], drawn, self._slope)
        offset = horizon.positions - horizon.state.robot.position[:, None]
        preferred = (offset * self._slope[:, None]).sum(axis=-1)
        return preferred + (self._value.costs(horizon) if self._value else 0.0)

    def attention(self, state: CrowdState) -> None:
        """Return nothing."""


def drive(
    policy: AnySearchPolicy,
    scenario: Scenario,
    cases: np.ndarray,
    seed: int,
    split: str,
    settings: PlannerTrainingConfig,
) -> Drive:
    """
    Run each case once; all worlds side by side until the last has ended.

    The network will be asked about a moment from as far away as the horizon. So an example is
    what was expected of this moment then, with the robot where it came to be.

    :param policy: its value may be a Preference; it is asked about all worlds at every step.
    """
    simulator = Simulator(scenario, len(cases), autoreset='disabled')
    state = simulator.reset(seed, split, cases)
    policy.reset()
    limits = limits_of(scenario)
    least = policy.time_left(state, limits)
    ahead = max(1, round(policy.times[-1] / scenario.time_step))
    expected: collections.deque = collections.deque(maxlen=ahead)
    seen: list[tuple[Observation, np.ndarray, np.ndarray, int]] = []
    costs: list[np.ndarray] = []
    outcome, time = np.zeros(len(cases), np.int8), np.zeros(len(cases))
    intrusion = np.zeros(len(cases))
    while (active := simulator.active).any():
        command = policy.act(state, limits)
        step = len(costs)
        if len(expected) == ahead and step % settings.stride == 0:
            seen.append((*example(policy, state, limits, expected[0], active), step))
        assert policy.prediction is not None
        agents = expected_state(state, policy.prediction, policy.last_layer).agents
        expected.append((agents.position, agents.velocity))
        state, _, _, _, info = simulator.step(command)
        close = active & (info['pedestrian_clearance'] < policy.settings.comfort_distance)
        intrusion += scenario.time_step * close
        ended = active & (info['outcome'] != Outcome.NONE)
        outcome[ended], time[ended] = info['outcome'][ended], info['time'][ended]
        cost = scenario.time_step * (1.0 + settings.intrusion * close)
        collided = ended & np.isin(info['outcome'], COLLISIONS)
        if collided.any():  # the rest of the way is not saved but still to be driven
            cost[collided] += settings.collision + policy.time_left(state, limits)[collided]
        costs.append(cost * active)
    lost = np.sum(costs, axis=0) - least
    return Drive(examples_of(seen, costs, outcome, settings), outcome, time, intrusion, lost)


def example(
    policy: AnySearchPolicy,
    state: CrowdState,
    limits: Limits | None,
    expected: tuple[np.ndarray, np.ndarray],
    active: np.ndarray,
) -> tuple[Observation, np.ndarray, np.ndarray]:
    """
    Return what the network sees of the active worlds, how far they are in time, and which.

    :param limits: of the robot; see `Policy.act`.
    :param expected: position and velocity of the agents, as they were predicted.
    """
    _, subgoals = policy.ways_on(state, state.robot.position[:, None])
    worlds = np.flatnonzero(active)
    placed = state.with_agents(position=expected[0], velocity=expected[1]).select(worlds)
    robot, goals = placed.robot, subgoals[worlds, 0]
    if policy.kinematics == 'holonomic':
        observation = observe_robots(placed, robot.position, goals)
    else:
        speeds = DifferentialDrive().present_command(robot)[:, 0]
        observation = observe_drives(placed, robot.position, goals, robot.heading, speeds)
    return padded(observation), policy.time_left(state, limits)[worlds], worlds


def padded(seen: Observation) -> Observation:
    """Return an observation with AGENTS slots for agents."""
    missing = AGENTS - seen.mask.shape[1]
    others = np.pad(seen.others, ((0, 0), (0, missing), (0, 0)))
    return Observation(seen.robot, others, np.pad(seen.mask, ((0, 0), (0, missing))))


def examples_of(
    seen: list[tuple[Observation, np.ndarray, np.ndarray, int]],
    costs: list[np.ndarray],
    outcome: np.ndarray,
    settings: PlannerTrainingConfig,
) -> Examples:
    """
    Return the examples with their costs.

    What a time-out would still have cost is not known: of such an episode only moments count that
    are at the largest cost already.
    """
    parts = [Examples(Observation.empty(AGENTS), np.zeros(0, np.float32))]
    to_go = np.cumsum(np.array(costs)[::-1], axis=0)[::-1]  # (steps, worlds)
    for observation, remaining, worlds, step in seen:
        cost = to_go[step, worlds] - remaining
        known = (outcome[worlds] != Outcome.TIMEOUT) | (cost >= settings.largest_cost)
        cost = np.clip(cost, -1.0, settings.largest_cost).astype(np.float32)
        parts.append(Examples(observation.select(known), cost[known]))
    return Examples.concatenate(parts)
