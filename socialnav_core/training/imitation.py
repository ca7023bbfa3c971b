"""Imitation: a value network learns what an ORCA robot's states turned out to be worth."""

from collections.abc import Callable
import dataclasses

import numpy as np
import torch
from torch import nn

from socialnav_core.config import require, TrainingConfig
from socialnav_core.policies import Policy
from socialnav_core.policies.value.observation import observe
from socialnav_core.simulation import Outcome, Simulator
from socialnav_core.states import Observation
from socialnav_core.training.mixed_worlds import MixedWorlds
from socialnav_core.training.optimizers import make_optimizer
from socialnav_core.training.regression import update, value_loss
from socialnav_core.training.schedules import exponential
from socialnav_core.training.targets import discounted_returns


@dataclasses.dataclass
class Demonstrations:
    """States that a demonstrator was in and the returns that followed."""

    observation: Observation
    """What the robot saw, batch axis first."""
    returns: np.ndarray
    """Discounted sum of rewards up to the end of the episode, float32, (batch,)."""
    outcome: np.ndarray
    """Outcome codes of all episodes in the order of their cases, (episodes,)."""

    def select(self, rows: np.ndarray) -> tuple[Observation, np.ndarray]:
        """
        Return some of the states and their returns.

        :param rows: indices or a mask.
        """
        return self.observation.select(rows), self.returns[rows]


def collect_demonstrations(
    simulator: Simulator | MixedWorlds,
    demonstrator: Policy,
    episodes: int,
    seed: int,
    progress: Callable[[int], object] | None = None,
) -> Demonstrations:
    """
    Return the states of the training cases 0 ... episodes - 1, each run exactly once.

    Returns are sums of the rewards received. An episode that ran out of time was cut in the
    middle, its sum is unknown and there is no value network yet to estimate the rest: its states
    are left out.

    :param progress: called with the number of episodes that have just ended.
    :raises ConfigError: when all of them ran out of time.
    """
    state = simulator.reset(seed=seed, split='train', cases=range(episodes))
    demonstrator.reset()
    steps, outcome = [], np.zeros(episodes, np.int64)
    while simulator.active.any():
        seen = observe(state, simulator.kinematics)
        state, reward, terminated, truncated, info = simulator.step(demonstrator.act(state))
        ended = info['active'] & (terminated | truncated)
        demonstrator.reset(ended)
        outcome[info['case_index'][ended]] = info['outcome'][ended]
        if progress is not None:
            progress(int(ended.sum()))
        steps.append((seen, reward, ended, info['case_index'], info['active']))
    require(
        bool((outcome != Outcome.TIMEOUT).any()),
        f'no demonstration ended within {simulator.scenario.time_limit:g} s; raise '
        'scenario.time_limit or training.imitation.episodes',
    )
    return demonstrations(steps, outcome, simulator.scenario.discount)


def demonstrations(steps: list[tuple], outcome: np.ndarray, discount: float) -> Demonstrations:
    """
    Return the states of finished episodes with their returns.

    :param steps: of all worlds: what was seen, rewards, ends, case indices, who was running.
    :param outcome: Outcome codes of the cases, (episodes,).
    :param discount: of one step.
    """
    seen, reward, ended, case, active = zip(*steps, strict=True)
    returns = discounted_returns(np.stack(reward), np.stack(ended), discount)
    kept = np.stack(active) & (outcome[np.stack(case)] != Outcome.TIMEOUT)
    observation = Observation.concatenate(seen).select(kept.ravel())
    return Demonstrations(observation, returns[kept].astype(np.float32), outcome)


def imitate(
    network: nn.Module,
    demonstrations: Demonstrations,
    config: TrainingConfig,
    generator: np.random.Generator,
    progress: Callable[[int], object] | None = None,
) -> float:
    """
    Fit the network to the demonstrations in place; return the mean loss of the last epoch.

    :param generator: source of the order.
    :param progress: called with 1 after each epoch.
    """
    settings = config.imitation
    optimizer = make_optimizer(network, config)
    count = len(demonstrations.returns)
    batches = -(-count // settings.batch_size)
    updates = settings.epochs * batches
    losses: list[float] = []
    for epoch in range(settings.epochs):
        losses.clear()
        for index, rows in enumerate(np.array_split(generator.permutation(count), batches)):
            share = (epoch * batches + index) / max(updates - 1, 1)
            rate = exponential(settings.learning_rate, settings.final_learning_rate, share)
            seen, returns = demonstrations.select(rows)
            arrays = (seen.robot, seen.others, seen.mask, returns)
            batch = tuple(torch.from_numpy(array) for array in arrays)
            loss = value_loss(network, batch, config.bfloat16)
            update(network, optimizer, loss, rate, config.gradient_clip)
            losses.append(loss.item())
        if progress is not None:
            progress(1)
    return float(np.mean(losses)) if losses else float('nan')
