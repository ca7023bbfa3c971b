"""What worlds that run side by side under an exploring policy bring, and what it is worth."""

from collections.abc import Sequence
import dataclasses

import numpy as np

from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.lookahead import Decision, ValuePolicy
from socialnav_core.prediction import ConstantVelocity
from socialnav_core.states import CrowdState, Observation
from socialnav_core.training.targets import one_step_targets, q_lambda_targets


@dataclasses.dataclass
class Transition:
    """One step of all worlds."""

    observation: Observation
    """What the robots saw before it, (worlds, ...)."""
    best_value: np.ndarray
    """Q* of that state, (worlds,)."""
    greedy: np.ndarray
    """Whether the action was the best one known, (worlds,)."""
    reward: np.ndarray
    """Reward received, (worlds,)."""
    terminated: np.ndarray
    """Whether it ended the episode for good, (worlds,)."""
    truncated: np.ndarray
    """Whether it was the last before the time limit, (worlds,)."""
    value_at_cut: np.ndarray
    """Q* of the state at which a truncated episode was cut, (worlds,)."""
    case_index: np.ndarray
    """Case of the episode, (worlds,)."""
    outcome: np.ndarray
    """Outcome codes, (worlds,)."""
    time: np.ndarray
    """Time since the start of the episode, s, (worlds,)."""
    following: Observation | None
    """What the robots saw after it, before any restart; only where a frozen network values it."""


@dataclasses.dataclass
class Rollout:
    """What some steps of all worlds brought."""

    observation: Observation
    """What the robots saw, (steps * worlds, ...)."""
    target: np.ndarray
    """What those states are worth, (steps * worlds,)."""
    episode: np.ndarray
    """Case index of each state, (steps * worlds,)."""
    case_index: np.ndarray
    """Cases that ended, (episodes,)."""
    outcome: np.ndarray
    """Outcome codes of these, (episodes,)."""
    time: np.ndarray
    """Durations of these, s, (episodes,)."""


def explore(decision: Decision, epsilon: float, generator: np.random.Generator) -> np.ndarray:
    """
    Return actions, (batch,): greedy, but for a share drawn uniformly from the whole set.

    :param epsilon: share of random actions.
    """
    batch, actions = decision.values.shape
    random = generator.integers(actions, size=batch)
    return np.where(generator.random(batch) < epsilon, random, decision.action)


def value_at_cut(policy: ValuePolicy, final: CrowdState, truncated: np.ndarray) -> np.ndarray:
    """
    Return the best value of states at which the time ran out, (batch,); zero elsewhere.

    The worlds have moved on to other episodes, so nobody knows the next step of the people in
    these states: they are taken to walk straight on.

    :param final: states before the restart.
    :param truncated: whether the time ran out, (batch,).
    """
    values = np.zeros(len(truncated), np.float32)
    if truncated.any():
        decision = policy.decide(final.select(truncated), predictor=ConstantVelocity())
        values[truncated] = decision.maximum()
    return values


def value_targets(
    steps: Sequence[Transition],
    last_value: np.ndarray,
    discount: float,
    trace_decay: float,
    frozen: ValueInference | None,
) -> np.ndarray:
    """
    Return what the states before the steps are worth, (steps, worlds).

    :param last_value: Q* of the state after the last step, (worlds,).
    :param discount: of one step.
    :param trace_decay: lambda of the targets.
    :param frozen: network of one-step targets, which replace those of Q(lambda); None for none.
    """
    reward = np.stack([step.reward for step in steps])
    terminated = np.stack([step.terminated for step in steps])
    if frozen:
        seen = Observation.concatenate([step.following for step in steps if step.following])
        next_value = frozen.values(seen.robot, seen.others, seen.mask).reshape(reward.shape)
        return one_step_targets(reward, terminated, next_value, discount)
    return q_lambda_targets(
        reward,
        terminated,
        truncated=np.stack([step.truncated for step in steps]),
        greedy=np.stack([step.greedy for step in steps]),
        best_value=np.stack([*(step.best_value for step in steps), last_value]),
        final_value=np.stack([step.value_at_cut for step in steps]),
        discount=discount,
        trace_decay=trace_decay,
    )


def joined(steps: Sequence[Transition], target: np.ndarray) -> Rollout:
    """
    Return the states of all steps with their targets, and the episodes that ended.

    :param target: of the states, (steps, worlds).
    """
    ended = np.concatenate([step.terminated | step.truncated for step in steps])
    case_index = np.concatenate([step.case_index for step in steps])
    return Rollout(
        Observation.concatenate([step.observation for step in steps]),
        target.ravel(),
        episode=case_index,
        case_index=case_index[ended],
        outcome=np.concatenate([step.outcome for step in steps])[ended],
        time=np.concatenate([step.time for step in steps])[ended],
    )
