"""Training of a planner, from random weights to a checkpoint."""

from collections.abc import Callable
import contextlib
import csv
import dataclasses
import math
from pathlib import Path
import shlex
import time

import numpy as np
import torch
from tqdm import tqdm

from socialnav_core.allocator import keep_freed_memory
from socialnav_core.config import Scenario, SearchConfig
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.policies.search.checkpoint import save_planner
from socialnav_core.policies.search.kinds import search_policy, with_base
from socialnav_core.policies.search.terminal import TerminalValue, Valuation
from socialnav_core.progress import progress_bar
from socialnav_core.simulation import Outcome
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.simulation.layout import PackingError
from socialnav_core.threads import chosen_threads
from socialnav_core.training.folder import finish_folder, own_folder
from socialnav_core.training.interruption import Interruption, TrainingInterrupted
from socialnav_core.training.planner.driving import COLLISIONS, Drive, drive, Examples, Preference
from socialnav_core.training.planner.run import PlannerRun
from socialnav_core.training.planner.worlds import draw_world
from socialnav_core.training.progress import CSV_NAME, open_csv
from socialnav_core.training.randomness import generator, Purpose
from socialnav_core.training.regression import update, value_loss
from socialnav_core.training.resume import load_state, save_state

COLUMNS = (
    'round', 'examples', 'loss', 'success_rate', 'collision_rate', 'mean_time', 'intrusion',
    'cost', 'cost_without', 'seconds', 'processor_seconds',
)  # fmt: skip
ATTEMPTS = 20
"""Worlds that are drawn, at most, until one has room for everybody."""


@chosen_threads()
def train_planner(
    config: PlannerConfig,
    out: Path,
    resume: bool = False,
    overwrite: bool = False,
    progress: bool = True,
) -> None:
    """
    Train the value network at the horizon of a search and leave a checkpoint folder.

    The network kept is the one that drives at least cost in the validation worlds. Every round is
    saved: a run that was killed goes on from the last one with `resume` and ends with the same
    bits (same machine, same number of threads).

    :raises ConfigError: when the folder is taken, or cannot be resumed with this configuration.
    :raises CheckpointError: when the state cannot be written.
    :raises TrainingInterrupted: after Ctrl-C or SIGTERM; the last whole round was saved.
    """
    with own_folder(out, resume, overwrite):
        run_in_folder(config, out, resume, progress)


def run_in_folder(config: PlannerConfig, out: Path, resume: bool, progress: bool) -> None:
    """Train in a folder that is prepared; see `train_planner`."""
    keep_freed_memory()
    with Interruption() as interruption:
        run = PlannerRun(config)
        if resume:
            run.restore(load_state(out, config))
        settings = config.training
        groups = settings.rounds * (settings.groups + settings.validation_groups)
        done = run.rounds * groups // settings.rounds
        with (
            open_csv(out / CSV_NAME, run.rounds, COLUMNS) as file,
            progress_bar(groups, 'planner', 'world', done, progress) as bar,
        ):
            rows = csv.DictWriter(file, COLUMNS)
            while not run.finished:
                row = iterate(run, lambda: stop_or_count(interruption, bar, run, out))
                rows.writerow({name: f'{value:.6g}' for name, value in row.items()})
                file.flush()
                save_planner(out, run.best, config)
                save_state(out, run.sections(), config)
    finish_folder(out)


def stop_or_count(interruption: Interruption, bar: tqdm, run: PlannerRun, out: Path) -> None:
    """Count a world; raise TrainingInterrupted where a signal came."""
    bar.update(1)
    if interruption.requested:
        place = shlex.quote(str(out))
        how = (
            f'go on with socialnav train-planner {place}/config.yaml --out {place} --resume'
            if run.rounds
            else 'nothing was saved yet'
        )
        raise TrainingInterrupted(
            f'stopped after {run.rounds} of {run.config.training.rounds} rounds; {how}',
            interruption.number,
        )


def iterate(run: PlannerRun, count: Callable[[], None]) -> dict[str, float]:
    """Drive, learn and measure once; return the numbers to report."""
    started, used = time.perf_counter(), time.process_time()
    settings = run.config.training
    value = terminal_value(run) if run.rounds else None
    drives = []
    for group in range(settings.groups):
        number = run.rounds * settings.groups + group
        draws = generator(run.config.seed, Purpose.PLANNER_WORLDS, number)
        preference = Preference(value, settings.exploration, settings.episodes, draws)
        drives.append(drive_somewhere(run.config, preference, number, 'train', draws))
        count()
    run.examples += [part.examples for part in drives]
    loss = fit(run)
    learned = measure(run.config, terminal_value(run), count)
    if math.isnan(run.cost_without):
        run.cost_without = measure(run.config, None, lambda: None)['cost']
    run.keep_best(learned['cost'])
    run.rounds += 1
    run.seconds += time.perf_counter() - started
    run.processor_seconds += time.process_time() - used
    return {
        'round': run.rounds,
        'examples': sum(len(part.cost) for part in run.examples),
        'loss': loss,
        **learned,
        'cost_without': run.cost_without,
        'seconds': run.seconds,
        'processor_seconds': run.processor_seconds,
    }


def terminal_value(run: PlannerRun) -> TerminalValue:
    """Return the network of a run as the search asks it."""
    return TerminalValue(run.network, kinematics_of(run.config.policy.kinematics))


def drive_somewhere(
    config: PlannerConfig,
    value: Valuation | None,
    number: int,
    split: str,
    draws: np.random.Generator,
) -> Drive:
    """
    Drive once through some cases of a world that is drawn for it.

    :param number: of the world; its cases are its own.
    :raises PackingError: when again and again a world has no room.
    """
    settings = config.training
    cases = np.arange(settings.episodes) + number * settings.episodes

    def attempt() -> Drive:
        scenario = with_base(draw_world(settings.named_share, draws), config.policy)
        policy = search_policy(fitting(config, scenario), value)
        return drive(policy, scenario, cases, config.seed, split, settings)

    for _ in range(ATTEMPTS - 1):
        with contextlib.suppress(PackingError):
            return attempt()
    return attempt()


def fitting(config: PlannerConfig, scenario: Scenario) -> SearchConfig:
    """Return the settings of the search with the goal tolerance and time step of a world."""
    return dataclasses.replace(
        config.policy, goal_tolerance=scenario.goal_tolerance, time_step=scenario.time_step
    )


def fit(run: PlannerRun) -> float:
    """Learn from all examples; return the mean loss of the last tenth of the updates."""
    settings, examples = run.config.training, Examples.concatenate(run.examples)
    draws = generator(run.config.seed, Purpose.PLANNER_BATCHES, run.rounds)
    optimizer = torch.optim.AdamW(
        run.network.parameters(), settings.learning_rate, weight_decay=settings.weight_decay,
        fused=True,
    )  # fmt: skip
    run.network.train()
    losses = []
    for step in range(settings.updates):
        rows = draws.integers(0, len(examples.cost), settings.batch_size)
        seen = examples.observation.select(rows)
        arrays = (seen.robot, seen.others, seen.mask, examples.cost[rows])
        batch = tuple(torch.from_numpy(array) for array in arrays)
        rate = settings.learning_rate * 0.5 * (1.0 + math.cos(math.pi * step / settings.updates))
        loss = value_loss(run.network, batch, bfloat16=False)
        update(run.network, optimizer, loss, rate, settings.gradient_clip)
        losses.append(loss.item())
    run.network.eval()
    return float(np.mean(losses[-max(1, len(losses) // 10) :]))


def measure(
    config: PlannerConfig, value: Valuation | None, count: Callable[[], None]
) -> dict[str, float]:
    """Return how a planner does in the validation worlds."""
    settings, drives = config.training, []
    for group in range(settings.validation_groups):
        draws = generator(config.seed, Purpose.PLANNER_VALIDATION, group)
        drives.append(drive_somewhere(config, value, group, 'validation', draws))
        count()
    outcome = np.concatenate([part.outcome for part in drives])
    time_spent = np.concatenate([part.time for part in drives])
    intrusion = np.concatenate([part.intrusion for part in drives])
    success, collided = outcome == Outcome.GOAL, np.isin(outcome, COLLISIONS)
    lost = np.concatenate([part.lost for part in drives])
    cost = np.where(outcome == Outcome.TIMEOUT, np.maximum(lost, settings.largest_cost), lost)
    return {
        'success_rate': float(success.mean()),
        'collision_rate': float(collided.mean()),
        'mean_time': float(time_spent[success].mean()) if success.any() else math.nan,
        'intrusion': float(intrusion.sum() / time_spent.sum()),
        'cost': float(cost.mean()),
    }
