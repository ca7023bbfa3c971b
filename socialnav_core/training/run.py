"""All that changes while a run goes on, and how it is stored."""

import copy
import dataclasses
from pathlib import Path
import shlex

import numpy as np
import torch

from socialnav_core.config import Config, PolicyConfig, Scenario, ScreeningConfig
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.lookahead import Decision, ValuePolicy
from socialnav_core.prediction.oracle import attach_simulator
from socialnav_core.simulation import Simulator
from socialnav_core.training.constant_features import without_constant_features
from socialnav_core.training.curriculum import Curriculum
from socialnav_core.training.episodes import EpisodeWindow
from socialnav_core.training.mixed_worlds import MixedWorlds
from socialnav_core.training.optimizers import make_optimizer
from socialnav_core.training.randomness import initial_network
from socialnav_core.training.replay_buffer import ReplayBuffer
from socialnav_core.training.resume import (
    Arrays,
    network_arrays,
    optimizer_arrays,
    restore_network,
    restore_optimizer,
    save_state,
)
from socialnav_core.training.rollout import Rollout
from socialnav_core.training.unfinished import UnfinishedEpisodes

REPORTED_EPISODES = 200


class Run:
    """A run: network, optimizer, replay, worlds, level and counters."""

    def __init__(self, config: Config) -> None:
        """Make everything as it is before the first iteration; the worlds are not laid out yet."""
        settings = config.training
        self.config = config
        self.network = initial_network(config.policy, config.seed).to(settings.device)
        self.optimizer = make_optimizer(self.network, settings)
        self.target_network = copy.deepcopy(self.network)
        self.frozen = None
        if settings.target_update_episodes:
            self.frozen = ValueInference(self.target_network, settings.bfloat16)
        self.buffer = ReplayBuffer(settings.replay_capacity, config.scenario.agents)
        self.unfinished = UnfinishedEpisodes(config.scenario.agents)
        self.episodes = EpisodeWindow(REPORTED_EPISODES, next_case=0)
        self.curriculum = None
        scenario = config.scenario
        if settings.curriculum.enabled:
            self.curriculum = Curriculum(settings.curriculum, next_case=0, seed=config.seed)
            scenario = self.curriculum.scenario(scenario)
        self.simulator = make_worlds(config, scenario)
        self.policy = ValuePolicy(self.network, exploring_policy(config), settings.bfloat16)
        attach_simulator(self.policy.predictor, self.simulator.next_agent_velocities)
        self.decision: Decision  # in the present state, by the weights of then
        self.iteration = 0
        self.ended_episodes = 0
        self.seconds = 0.0
        self.processor_seconds = 0.0

    @property
    def obstacle_radius(self) -> float:
        """Return the largest obstacle radius of the episodes that begin now, m."""
        return self.simulator.scenario.obstacle_radius_max

    @property
    def position(self) -> int:
        """Return how much is done, in the unit of the run's length: episodes or iterations."""
        return self.ended_episodes if self.config.training.episodes else self.iteration

    @property
    def finished(self) -> bool:
        """Return whether the run is as long as it should be."""
        return self.position >= self.config.training.length

    def store(self, rollout: Rollout) -> None:
        """Add what was collected to the replay."""
        if self.config.training.store_timeouts:
            self.buffer.append(rollout.observation, rollout.target)
        else:
            self.buffer.append(*self.unfinished.release(rollout))

    def renew_target(self) -> None:
        """Let the network of one-step targets have the weights of now."""
        self.target_network.load_state_dict(self.network.state_dict())

    def finished_network(self) -> torch.nn.Module:
        """Return a copy of the network, on the CPU, as it is to be used."""
        if self.config.training.fold_constant_features and self.buffer.size:
            return without_constant_features(self.network, self.buffer)
        return copy.deepcopy(self.network).cpu()

    def record(self, rollout: Rollout) -> None:
        """Count the episodes that ended, renew the targets and raise the level when it is time."""
        ended = (rollout.case_index, rollout.outcome, rollout.time)
        period = self.config.training.target_update_episodes
        before = self.ended_episodes
        self.ended_episodes += len(rollout.case_index)
        if period and before // period != self.ended_episodes // period:
            self.renew_target()
        self.episodes.record(*ended)
        if self.curriculum is None or isinstance(self.simulator, MixedWorlds):
            return
        self.curriculum.window.record(*ended)
        if self.curriculum.advance(int(self.simulator.case_index.max()) + 1):
            self.curriculum.apply(self.simulator, self.config.scenario)

    def sections(self) -> dict[str, Arrays]:
        """Return all that `restore` needs, part by part."""
        counters = {
            'iteration': np.array(self.iteration),
            'ended_episodes': np.array(self.ended_episodes),
            'seconds': np.array(self.seconds),
            'processor_seconds': np.array(self.processor_seconds),
        }
        settings = self.config.training
        return {
            'network': network_arrays(self.network),
            'target_network': network_arrays(self.target_network) if self.frozen else {},
            'optimizer': optimizer_arrays(self.optimizer),
            'buffer': self.buffer.get_state(),
            'unfinished': {} if settings.store_timeouts else self.unfinished.get_state(),
            'episodes': self.episodes.get_state(),
            'curriculum': self.curriculum.get_state() if self.curriculum else {},
            'simulator': self.simulator.get_state(),
            'decision': dataclasses.asdict(self.decision),
            'counters': counters,
        }

    def restore(self, sections: dict[str, Arrays]) -> None:
        """
        Go on from a stored state.

        :param sections: from `sections` of a run with the same configuration.
        """
        restore_network(self.network, sections['network'])
        if self.frozen:
            restore_network(self.target_network, sections['target_network'])
        restore_optimizer(self.optimizer, sections.get('optimizer', {}))
        self.buffer.set_state(sections['buffer'])
        if not self.config.training.store_timeouts:
            self.unfinished.set_state(sections['unfinished'])
        self.episodes.set_state(sections['episodes'])
        if self.curriculum and isinstance(self.simulator, Simulator):
            self.curriculum.set_state(sections['curriculum'])
            self.curriculum.apply(self.simulator, self.config.scenario)
        self.simulator.set_state(sections['simulator'])
        self.decision = Decision(**sections['decision'])
        counters = sections['counters']
        self.iteration = int(counters['iteration'])
        self.ended_episodes = int(counters['ended_episodes'])
        self.seconds = float(counters['seconds'])
        self.processor_seconds = float(counters['processor_seconds'])


def make_worlds(config: Config, scenario: Scenario) -> Simulator | MixedWorlds:
    """
    Return the worlds of a run, which are not laid out yet.

    :param scenario: of the first level of a curriculum, else that of the run.
    :raises PackingError: when no kind of world finds room.
    """
    settings = config.training
    if settings.kinds:
        return MixedWorlds(scenario, settings.kinds, settings.worlds, config.seed)
    return Simulator(scenario, settings.worlds)


def exploring_policy(config: Config) -> PolicyConfig:
    """Return how actions are chosen in training: by the look-ahead of training, unscreened."""
    return dataclasses.replace(
        config.policy, lookahead=config.training.lookahead, screening=ScreeningConfig()
    )


def save(run: Run, out: Path) -> None:
    """Store the weights, which can be used, and the state, from which the run can be resumed."""
    save_weights(out, run.finished_network(), run.config)
    save_state(out, run.sections(), run.config)


def save_unfolded(run: Run, out: Path) -> None:
    """Store the weights as they were trained, in a checkpoint of its own, for comparison."""
    settings = dataclasses.replace(run.config.training, fold_constant_features=False)
    save_weights(out, run.network, dataclasses.replace(run.config, training=settings))


def how_to_resume(run: Run, out: Path) -> str:
    """Return what to tell the one who stopped a run."""
    config, folder = shlex.quote(str(out / 'config.yaml')), shlex.quote(str(out))
    settings = run.config.training
    return (
        f'stopped and saved after {run.position} of {settings.length} '
        f'{"episodes" if settings.episodes else "iterations"}; '
        f'go on with: socialnav train {config} --out {folder} --resume'
    )
