"""Training of a value network: imitation, then collection and updates in turn."""

from collections.abc import Callable
import dataclasses
from pathlib import Path
import shlex
import sys
import time
from typing import Any

import numpy as np

from socialnav_core.allocator import keep_freed_memory
from socialnav_core.config import Config, require, Scenario
from socialnav_core.policies import Policy
from socialnav_core.policies.value.checkpoint import load_checkpoint, save_weights
from socialnav_core.policies.value.lookahead import ValuePolicy
from socialnav_core.prediction import make_predictor
from socialnav_core.progress import progress_bar
from socialnav_core.threads import chosen_threads
from socialnav_core.training.demonstrators import make_demonstrator
from socialnav_core.training.folder import finish_folder, prepare_folder, UNFOLDED
from socialnav_core.training.imitation import collect_demonstrations, imitate
from socialnav_core.training.interruption import Interruption, TrainingInterrupted
from socialnav_core.training.model_card import add_result, write_model_card
from socialnav_core.training.precision import with_available_precision
from socialnav_core.training.progress import Progress
from socialnav_core.training.randomness import generator, Purpose
from socialnav_core.training.regression import regress
from socialnav_core.training.resume import load_state, save_state
from socialnav_core.training.rollout import collect, Rollout
from socialnav_core.training.run import Run
from socialnav_core.training.schedules import epsilon, learning_rate

Evaluate = Callable[[Policy, Scenario], dict[str, Any]]


@chosen_threads()
def train(
    config: Config,
    out: Path,
    resume: bool = False,
    overwrite: bool = False,
    evaluate: Evaluate | None = None,
    progress: bool = True,
) -> None:
    """
    Train a value network and leave a checkpoint folder.

    Every saved state is complete: a run that was killed goes on from the last one with `resume`
    and ends with the same bits as one that was not (same machine, same number of threads).

    :param config: the run.
    :param out: folder of the run.
    :param resume: go on with the run in the folder.
    :param overwrite: replace the run in the folder.
    :param evaluate: measures the finished policy in a scenario; its result becomes metrics.json.
    :param progress: whether to show on stderr how it goes.
    :raises ConfigError: when the folder is taken, or cannot be resumed with this configuration, or
        for a prediction that does not exist.
    :raises CheckpointError: when the state cannot be written.
    :raises TrainingInterrupted: after Ctrl-C or SIGTERM; the run was saved.
    """
    config = with_available_precision(config)
    settings = config.training
    require_predictions(config)
    prepare_folder(out, resume, overwrite)
    run = Run(config)
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
            raise TrainingInterrupted(how_to_resume(run, out))
    if evaluate is not None:
        policy = ValuePolicy(run.finished_network(), config.policy)
        add_result(out, config, evaluate(policy, config.scenario))
    if settings.fold_constant_features:
        save_unfolded(run, out / UNFOLDED)
    write_model_card(out, load_checkpoint(out))
    finish_folder(out)


def require_predictions(config: Config) -> None:
    """Raise a ConfigError unless the predictions of a run exist and it could be resumed."""
    make_predictor(config.policy.lookahead)
    require(
        not make_predictor(config.training.lookahead).remembers,
        f'training.lookahead {config.training.lookahead} has a history, which no run stores; '
        'use oracle or constant_velocity',
    )


def begin(run: Run, progress: bool) -> None:
    """
    Imitate, fill the replay with demonstrations and start the worlds of value learning.

    Half of the replay is filled, so that the other half is there for what comes.

    :param run: before its first iteration.
    :param progress: whether to say on stderr what happens.
    """
    started, used = time.perf_counter(), time.process_time()
    config, settings = run.config, run.config.training
    imitation = settings.imitation
    if imitation.episodes:
        with progress_bar(imitation.episodes, 'demonstrations', visible=progress) as bar:
            demonstrations = collect_demonstrations(
                run.simulator, make_demonstrator(imitation), imitation.episodes, config.seed,
                bar.update,
            )  # fmt: skip
        count = len(demonstrations.returns)
        announce(f'imitation: {imitation.episodes} episodes of ORCA, {count} states', progress)
        random = generator(config.seed, Purpose.IMITATION)
        with progress_bar(imitation.epochs, 'imitation', 'epoch', visible=progress) as bar:
            imitate(run.network, demonstrations, settings, random, bar.update)
        order = generator(config.seed, Purpose.SELECTION).permutation(count)
        run.buffer.append(*demonstrations.select(order[: settings.replay_capacity // 2]))
    run.renew_target()
    run.decision = run.policy.decide(run.simulator.reset(seed=config.seed, split='train'))
    run.seconds = time.perf_counter() - started
    run.processor_seconds = time.process_time() - used


def iterate(run: Run) -> dict[str, float]:
    """
    Run all worlds for some steps, then update the network; return the numbers to report.

    :param run: the run, advanced by one iteration.
    """
    started, used = time.perf_counter(), time.process_time()
    config, settings, iteration = run.config, run.config.training, run.iteration
    rate, exploration = learning_rate(settings, run.position), epsilon(settings, run.position)
    rollout = collect(
        run.simulator,
        run.policy,
        run.decision,
        settings.steps_per_iteration,
        exploration,
        settings.trace_decay,
        generator(config.seed, Purpose.EXPLORATION, iteration),
        run.frozen,
    )
    run.decision = rollout.decision
    run.store(rollout)

    draws = generator(config.seed, Purpose.REPLAY, iteration)
    losses = []
    for _ in range(updates_after(rollout, run)):
        batch = run.buffer.sample(draws, settings.batch_size)
        losses.append(
            regress(
                run.network, run.optimizer, batch, rate, settings.gradient_clip, settings.bfloat16
            )
        )

    radius = run.obstacle_radius
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


def updates_after(rollout: Rollout, run: Run) -> int:
    """
    Return the number of updates after a rollout; none while there is nothing to replay.

    :param rollout: of the iteration.
    :param run: the run, with the rollout stored.
    """
    settings = run.config.training
    if not run.buffer.size:
        return 0
    if settings.updates_per_episode:
        return settings.updates_per_episode * len(rollout.case_index)
    return settings.updates_per_iteration


def save(run: Run, out: Path) -> None:
    """
    Store the weights, so that the folder can be used, and the state, so that it can be resumed.

    :param run: between two iterations.
    :param out: folder of the run.
    """
    save_weights(out, run.finished_network(), run.config)
    save_state(out, run.sections(), run.config)


def save_unfolded(run: Run, out: Path) -> None:
    """
    Store the weights as they were trained, in a checkpoint of its own, for comparison.

    :param run: that is finished.
    :param out: folder of that checkpoint.
    """
    settings = dataclasses.replace(run.config.training, fold_constant_features=False)
    save_weights(out, run.network, dataclasses.replace(run.config, training=settings))


def how_to_resume(run: Run, out: Path) -> str:
    """
    Return what to tell the one who stopped a run.

    :param run: stopped and saved.
    :param out: its folder.
    """
    config, folder = shlex.quote(str(out / 'config.yaml')), shlex.quote(str(out))
    settings = run.config.training
    return (
        f'stopped and saved after {run.position} of {settings.length} '
        f'{"episodes" if settings.episodes else "iterations"}; '
        f'go on with: socialnav train {config} --out {folder} --resume'
    )


def announce(text: str, progress: bool) -> None:
    """
    Say on stderr what happens.

    :param text: one line.
    :param progress: whether anything is to be said.
    """
    if progress:
        print(text, file=sys.stderr, flush=True)
