"""Training of a value network: imitation, then collection and updates in turn."""

from collections.abc import Callable
from pathlib import Path
import time
from typing import Any

import numpy as np
from torch import nn

from socialnav_core.allocator import keep_freed_memory
from socialnav_core.config import Config, require, Scenario
from socialnav_core.memory import require_memory, training_bytes
from socialnav_core.policies import Policy
from socialnav_core.policies.value.checkpoint import load_checkpoint
from socialnav_core.policies.value.lookahead import ValuePolicy
from socialnav_core.policies.value.observation import observe
from socialnav_core.prediction import make_predictor
from socialnav_core.threads import chosen_threads
from socialnav_core.training.folder import finish_folder, own_folder, UNFOLDED
from socialnav_core.training.initial_weights import with_initial_weights
from socialnav_core.training.interruption import Interruption, TrainingInterrupted
from socialnav_core.training.model_card import add_result, write_model_card
from socialnav_core.training.precision import with_available_precision
from socialnav_core.training.progress import Progress
from socialnav_core.training.randomness import generator, Purpose
from socialnav_core.training.regression import update, value_loss
from socialnav_core.training.resume import load_state
from socialnav_core.training.rollout import (
    explore,
    joined,
    Rollout,
    Transition,
    value_at_cut,
    value_targets,
)
from socialnav_core.training.run import how_to_resume, Run, save, save_unfolded
from socialnav_core.training.schedules import epsilon, learning_rate
from socialnav_core.training.warm_up import begin

Evaluate = Callable[[Policy, Scenario], dict[str, Any]]


@chosen_threads()
def train(
    config: Config,
    out: Path,
    resume: bool = False,
    overwrite: bool = False,
    init: str | Path | None = None,
    evaluate: Evaluate | None = None,
    progress: bool = True,
) -> None:
    """
    Train a value network and leave a checkpoint folder.

    Every saved state is complete: a run that was killed goes on from the last one with `resume`
    and ends with the same bits as one that was not (same machine, same number of threads).

    :param resume: go on with the run in the folder; one that is finished needs a greater length.
    :param init: checkpoint, or name of one in models/, whose weights the run begins with.
    :param evaluate: measures the finished policy in a scenario; its result becomes metrics.json.
    :raises ConfigError: when the folder is taken, or cannot be resumed with this configuration, or
        for a prediction that does not exist.
    :raises CheckpointError: when the state cannot be written, or `init` is damaged.
    :raises FloatingPointError: when the loss is not a number.
    :raises TrainingInterrupted: after Ctrl-C or SIGTERM; the run was saved.
    """
    config = with_available_precision(config)
    require_predictions(config)
    require_memory(training_bytes(config), 'the training')
    config, network = with_initial_weights(config, init, resume)
    with own_folder(out, resume, overwrite):
        run_in_folder(config, out, network, resume, evaluate, progress)


def run_in_folder(
    config: Config,
    out: Path,
    network: nn.Module | None,
    resume: bool,
    evaluate: Evaluate | None,
    progress: bool,
) -> None:
    """
    Train in a folder that is prepared; see `train`.

    :param network: with the weights to begin with; None for random ones.
    """
    settings = config.training
    run = Run(config)
    if network is not None:
        run.network.load_state_dict(network.state_dict())
    keep_freed_memory()
    with Interruption() as interruption:
        if resume:
            run.restore(load_state(out, config))
        else:
            begin(run, progress)
            save(run, out)
        with Progress(out, settings, run.iteration, run.position, progress) as reports:
            while not run.finished and not interruption.requested:
                reports.report(iterate(run))
                if run.iteration % settings.checkpoint_iterations == 0:
                    save(run, out)
        save(run, out)
        if interruption.requested:
            raise TrainingInterrupted(how_to_resume(run, out), interruption.number)
    if evaluate is not None:
        policy = ValuePolicy(run.finished_network(), config.policy)
        add_result(out, config, evaluate(policy, config.scenario))
    if settings.fold_constant_features:
        save_unfolded(run, out / UNFOLDED)
    write_model_card(out, load_checkpoint(out))
    finish_folder(out)


def iterate(run: Run) -> dict[str, float]:
    """Advance the run by one iteration of `learn`; return the numbers to report."""
    started, used = time.perf_counter(), time.process_time()
    settings, radius = run.config.training, run.obstacle_radius
    rate, exploration = learning_rate(settings, run.position), epsilon(settings, run.position)
    rollout, losses = learn(run, rate, exploration)
    run.record(rollout)
    run.iteration += 1
    seconds = time.perf_counter() - started
    run.seconds += seconds
    run.processor_seconds += time.process_time() - used
    decisions = settings.worlds * settings.steps_per_iteration
    return {
        'iteration': run.iteration,
        'decisions': run.iteration * decisions,
        'episodes': run.ended_episodes,
        'success_rate': run.episodes.success_rate,
        'collision_rate': run.episodes.collision_rate,
        'mean_time': run.episodes.mean_time,
        'loss': float(np.mean(losses)) if losses else float('nan'),
        'learning_rate': rate,
        'epsilon': exploration,
        'obstacle_radius': radius,
        'decisions_per_second': decisions / seconds,
        'seconds': run.seconds,
        'processor_seconds': run.processor_seconds,
    }


def learn(run: Run, rate: float, exploration: float) -> tuple[Rollout, list[float]]:
    """
    Act and step in all worlds, store what that brought, and update the network from the replay.

    :param rate: learning rate of the updates.
    :param exploration: share of random actions.
    """
    config, settings = run.config, run.config.training
    simulator, policy, worlds = run.simulator, run.policy, np.arange(settings.worlds)
    chance = generator(config.seed, Purpose.EXPLORATION, run.iteration)
    transitions = []
    for _ in range(settings.steps_per_iteration):
        # act
        seen, decision = observe(simulator.state, policy.motion), run.decision
        action = explore(decision, exploration, chance)
        command = decision.commands[worlds, action]

        # step; worlds whose episode ended are in the next one already, but for `final`
        state, reward, terminated, truncated, info = simulator.step(command)
        final = info['final_state']
        transitions.append(Transition(
            observation=seen,
            best_value=decision.maximum(),
            greedy=action == decision.action,
            reward=reward,
            terminated=terminated,
            truncated=truncated,
            value_at_cut=value_at_cut(policy, final, truncated),
            case_index=info['case_index'],
            outcome=info['outcome'],
            time=info['time'],
            following=observe(final, policy.motion) if run.frozen else None,
        ))  # fmt: skip
        policy.reset(terminated | truncated)
        run.decision = policy.decide(state)

    # store, each state with its target
    target = value_targets(
        transitions, run.decision.maximum(), config.scenario.discount, settings.trace_decay,
        run.frozen,
    )  # fmt: skip
    rollout = joined(transitions, target)
    run.store(rollout)

    # sample, loss, update
    draws, losses = generator(config.seed, Purpose.REPLAY, run.iteration), []
    for _ in range(updates_after(rollout, run)):
        batch = run.buffer.sample(draws, settings.batch_size)
        loss = value_loss(run.network, batch, settings.bfloat16)
        update(run.network, run.optimizer, loss, rate, settings.gradient_clip)
        losses.append(loss.item())
    return rollout, losses


def updates_after(rollout: Rollout, run: Run) -> int:
    """Return the number of updates after a rollout; none while there is nothing to replay."""
    settings = run.config.training
    if not run.buffer.size:
        return 0
    if settings.updates_per_episode:
        return settings.updates_per_episode * len(rollout.case_index)
    return settings.updates_per_iteration


def require_predictions(config: Config) -> None:
    """Raise a ConfigError unless the predictions of a run exist and it could be resumed."""
    make_predictor(config.policy.lookahead)
    require(
        not make_predictor(config.training.lookahead).remembers,
        f'training.lookahead {config.training.lookahead} has a history, which no run stores; '
        'use oracle or constant_velocity',
    )
