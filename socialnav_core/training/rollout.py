"""Collection: worlds that run side by side under an exploring policy."""

import dataclasses

import numpy as np

from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.lookahead import Decision, ValuePolicy
from socialnav_core.policies.value.observation import observe
from socialnav_core.prediction import ConstantVelocity
from socialnav_core.simulation import Simulator
from socialnav_core.states import CrowdState, Observation
from socialnav_core.training.targets import one_step_targets, q_lambda_targets


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
    decision: Decision
    """What the policy would do next, greedily; the first decision of the next rollout."""


def collect(
    simulator: Simulator,
    policy: ValuePolicy,
    decision: Decision,
    steps: int,
    epsilon: float,
    trace_decay: float,
    generator: np.random.Generator,
    frozen: ValueInference | None = None,
) -> Rollout:
    """
    Run all worlds for some steps, with a random action in a share of them.

    :param simulator: worlds, restarted as their episodes end.
    :param policy: decides.
    :param decision: of the policy in the present state.
    :param steps: number of steps of each world.
    :param epsilon: share of random actions.
    :param trace_decay: lambda of the targets.
    :param generator: source of exploration.
    :param frozen: network of one-step targets, which replace those of Q(lambda); None for none.
    """
    worlds = np.arange(simulator.batch_size)
    observations, next_observations, flows, ended_episodes = [], [], [], []
    best_values = [decision.maximum()]
    for _ in range(steps):
        observations.append(observe(simulator.state, policy.motion))
        action = explore(decision, epsilon, generator)
        command = decision.commands[worlds, action]
        state, reward, terminated, truncated, info = simulator.step(command)
        flow = {
            'reward': reward,
            'terminated': terminated,
            'truncated': truncated,
            'greedy': action == decision.action,
            'case_index': info['case_index'],
            'final_value': value_at_cut(policy, info['final_state'], truncated),
        }
        flows.append(flow)
        if frozen:
            next_observations.append(observe(info['final_state'], policy.motion))
        ended = terminated | truncated
        ended_episodes.append([info[name][ended] for name in ('case_index', 'outcome', 'time')])
        policy.reset(ended)
        decision = policy.decide(state)
        best_values.append(decision.maximum())
    flow = {name: np.stack([flow[name] for flow in flows]) for name in flows[0]}
    episode, discount = flow.pop('case_index').ravel(), simulator.scenario.discount
    if frozen:
        seen = joined(next_observations)
        next_value = frozen.values(seen.robot, seen.others, seen.mask).reshape(steps, -1)
        target = one_step_targets(flow['reward'], flow['terminated'], next_value, discount)
    else:
        target = q_lambda_targets(
            **flow, best_value=np.stack(best_values), discount=discount, trace_decay=trace_decay
        )
    columns = zip(*ended_episodes, strict=True)
    case_index, outcome, time = (np.concatenate(column) for column in columns)
    seen = joined(observations)
    return Rollout(seen, target.ravel(), episode, case_index, outcome, time, decision)


def explore(decision: Decision, epsilon: float, generator: np.random.Generator) -> np.ndarray:
    """
    Return actions, (batch,): greedy, but for a share drawn uniformly from the whole set.

    :param decision: of the policy.
    :param epsilon: share of random actions.
    :param generator: source of randomness.
    """
    batch, actions = decision.values.shape
    random = generator.integers(actions, size=batch)
    return np.where(generator.random(batch) < epsilon, random, decision.action)


def value_at_cut(policy: ValuePolicy, final: CrowdState, truncated: np.ndarray) -> np.ndarray:
    """
    Return the best value of states at which the time ran out, (batch,); zero elsewhere.

    The worlds have moved on to other episodes, so nobody knows the next step of the people in
    these states: they are taken to walk straight on.

    :param policy: values the states.
    :param final: states before the restart.
    :param truncated: whether the time ran out, (batch,).
    """
    values = np.zeros(len(truncated), np.float32)
    if truncated.any():
        decision = policy.decide(final.select(truncated), predictor=ConstantVelocity())
        values[truncated] = decision.maximum()
    return values


def joined(observations: list[Observation]) -> Observation:
    """
    Return observations one after the other along the batch axis.

    :param observations: batches of the same number of agents.
    """
    return Observation(
        *(
            np.concatenate([getattr(each, name) for each in observations])
            for name in ('robot', 'others', 'mask')
        )
    )
