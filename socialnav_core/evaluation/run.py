"""Run a policy on given cases, each exactly once, and measure it."""

from collections.abc import Callable, Iterable, Mapping
import dataclasses
import time
from typing import Any

import numpy as np

from socialnav_core.allocator import keep_freed_memory
from socialnav_core.config import ObservationConfig, Scenario
from socialnav_core.config.ranges import Range, require_rule
from socialnav_core.config.scenarios import changes_of
from socialnav_core.evaluation.observed import Observer
from socialnav_core.evaluation.statistics import wilson_interval
from socialnav_core.memory import evaluation_bytes, require_memory
from socialnav_core.metrics import (
    case_mappings,
    EpisodeRecorder,
    EpisodeRecords,
    FORESEEN_RANGE,
    FORESEEN_STEPS,
    METRICS,
    summarise,
)
from socialnav_core.policies.protocol import (
    Policy,
    PolicyDescription,
    require_same_kinematics,
)
from socialnav_core.prediction.oracle import attach_simulator
from socialnav_core.progress import progress_bar
from socialnav_core.simulation import Simulator
from socialnav_core.simulation.kinematics import Limits, limits_of
from socialnav_core.states import CrowdState

EPISODES = Range(1, 100_000_000)
BATCH_SIZE = 128
"""Worlds that are run side by side; the results do not depend on it."""


@dataclasses.dataclass(frozen=True)
class EvaluationResult:
    """What a policy did in the cases 0 to episodes - 1 of a scenario."""

    model: str
    """Name of the policy."""
    scenario: str
    """Name of the scenario."""
    seed: int
    """Seed of the cases."""
    split: str
    """Split of the cases."""
    policy: PolicyDescription
    """What the policy is: its prediction, what that knows, screening."""
    records: EpisodeRecords
    """How each episode went."""
    decision_seconds: float
    """Time spent in the policy, s."""
    changes: Mapping[str, Any] = dataclasses.field(default_factory=dict)
    """Settings in which the scenario differs from the one of its name."""

    @property
    def episodes(self) -> int:
        """Return the number of cases."""
        return len(self.records.case_index)

    @property
    def decisions_per_second(self) -> float:
        """Return decisions made per second spent in the policy."""
        return float(self.records.steps.sum() / self.decision_seconds)

    @property
    def success_rate(self) -> float:
        """Return the share of the cases in which the robot reached its goal."""
        return float(self.records.success.mean())

    @property
    def success_interval(self) -> tuple[float, float]:
        """Return Wilson's 95 % interval of the success rate."""
        return self.interval('success_rate')

    def interval(self, metric: str) -> tuple[float, float]:
        """
        Return Wilson's 95 % interval of a rate.

        :param metric: name of one that is true or false in each episode, or NaN where it does not
            count.
        """
        values = METRICS[metric].measure(self.records).astype(float)
        counted = values[np.isfinite(values)]
        return wilson_interval(int(counted.sum()), len(counted))

    def summary(self, further: Iterable[str] = ()) -> dict[str, float | None]:
        """
        Return the figure of each metric by name.

        :param further: names of metrics besides those that are always measured, or `all`.
        """
        return summarise(self.records, further)

    def to_mapping(self, further: Iterable[str] = ()) -> dict[str, Any]:
        """
        Return everything as plain values, fit for JSON.

        :param further: names of metrics besides those that are always measured, or `all`.
        """
        named = ('model', 'scenario', 'seed', 'split', 'episodes')
        return {
            **{name: getattr(self, name) for name in named},
            'changes': dict(self.changes),
            'lookahead': self.policy.prediction,
            'knowledge': self.policy.knowledge,
            'screening': self.policy.screening,
            'success_interval': list(self.success_interval),
            **self.summary(further),
            'decisions_per_second': self.decisions_per_second,
            'cases': case_mappings(self.records, further),
        }


def evaluate(
    policy: Policy,
    scenario: Scenario,
    episodes: int = 500,
    seed: int = 0,
    split: str = 'test',
    batch_size: int = BATCH_SIZE,
    name: str = '',
    progress: Callable[[int], None] | bool = False,
    foresight: bool = False,
    observation: ObservationConfig | None = None,
) -> EvaluationResult:
    """
    Run the cases 0 to episodes - 1, each exactly once.

    :param episodes: number of cases, at least 1.
    :param split: train, validation or test.
    :param batch_size: worlds that are run side by side.
    :param name: name of the policy in the result.
    :param progress: whether to say on stderr how it goes; or what to call instead, with the number
        of episodes that have just ended.
    :param foresight: whether to note where people would be some steps later, which takes time.
    :param observation: how people are seen; None: as they are.
    :raises ConfigError: when the policy drives another kind of robot, or for no episodes.
    """
    if progress is True:
        with progress_bar(episodes, name or 'evaluation') as bar:
            report = bar.update
            return evaluate(
                policy, scenario, episodes, seed, split, batch_size, name, report, foresight,
                observation,
            )  # fmt: skip
    keep_freed_memory()
    require_rule(int, EPISODES, episodes, 'the number of episodes')
    require_same_kinematics(policy, scenario)
    actions = getattr(getattr(policy, 'config', None), 'actions', 1)
    needed = evaluation_bytes(episodes, min(batch_size, episodes), scenario, actions)
    require_memory(needed, f'{episodes} episodes')
    limits = limits_of(scenario)
    recorder = EpisodeRecorder(episodes, scenario.goal_tolerance)
    simulator = Simulator(scenario, min(batch_size, episodes))
    state = simulator.reset(seed=seed, split=split, cases=np.arange(episodes))
    policy.reset()
    attach_simulator(
        policy.predictor,
        lambda: simulator.next_agent_velocities()[asked_worlds(policy, simulator.active)],
    )
    observer = Observer(observation, scenario, seed) if observation else None
    seconds, steps = 0.0, np.zeros(simulator.batch_size, np.int64)
    while (active := simulator.active).any():
        seen = observer.see(state, simulator.case_index, steps) if observer else state
        started = time.perf_counter()
        command = commands_where_active(policy, seen, active, limits)
        seconds += time.perf_counter() - started
        before = state
        foreseen = foreseen_distance(before, simulator) if foresight else None
        state, _, terminated, truncated, info = simulator.step(command)
        ended = np.flatnonzero(terminated | truncated)
        recorder.add(before, command, info, ended, foreseen)
        steps = np.where(terminated | truncated, 0, info['steps'])
        if len(ended):
            policy.reset(ended)
            if callable(progress):
                progress(len(ended))
    return EvaluationResult(
        model=name,
        scenario=scenario.name,
        seed=seed,
        split=split,
        policy=policy.description,
        records=recorder.records(),
        decision_seconds=seconds,
        changes=changes_of(scenario),
    )


def foreseen_distance(state: CrowdState, simulator: Simulator) -> np.ndarray:
    """Return the least distance to where visible people would be in some steps, m, (batch,)."""
    robot, agents = state.robot, state.agents
    offset = agents.position - robot.position[:, None]
    gap = np.hypot(offset[..., 0], offset[..., 1]) - agents.radius - robot.radius[:, None]
    seen = agents.valid & ~agents.static & (gap <= FORESEEN_RANGE)
    later = simulator.foresee(FORESEEN_STEPS) - robot.position[:, None, None]
    distance = np.where(seen[:, None], np.hypot(later[..., 0], later[..., 1]), np.inf)
    return distance.min(axis=(1, 2), initial=np.inf)


def asked_worlds(policy: Policy, active: np.ndarray) -> np.ndarray:
    """
    Return the worlds that a policy is asked about, bool (batch,).

    Those are the active ones; a policy that remembers is always asked about all, so that each
    row stays the same world.
    """
    return np.ones_like(active) if policy.description.remembers else active


def commands_where_active(
    policy: Policy, state: CrowdState, active: np.ndarray, limits: Limits | None = None
) -> np.ndarray:
    """
    Return the commands of a policy in all worlds, zero where it is not asked, (batch, 2).

    :param active: which worlds run, bool (batch,).
    :param limits: what the robots can do, None: anything.
    """
    asked = asked_worlds(policy, active)
    if asked.all():
        return policy.act(state, limits)
    commands = np.zeros((len(asked), 2))
    commands[asked] = policy.act(state.select(asked), limits)
    return commands
