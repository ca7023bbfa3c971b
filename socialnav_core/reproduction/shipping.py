"""The best seed of a row, with its measurements and card, into models/."""

from collections.abc import Sequence
import json
from pathlib import Path
import shutil

import numpy as np

from socialnav_core.policies.checkpoint import (
    atomic_write,
    checkpoint_digest,
    CONFIG,
    WEIGHTS,
)
from socialnav_core.reproduction.experiments import Entry
from socialnav_core.reproduction.laboratory import Laboratory, Request
from socialnav_core.reproduction.measurements import Cases, Measurement
from socialnav_core.training import write_model_card
from socialnav_core.training.model_card import METRICS_NAME
from socialnav_core.training.progress import CSV_NAME

CARD_EPISODES = 5000
CHOICE_EPISODES = 500
LOOKAHEAD = 'constant_velocity'


def ship(
    entries: Sequence[Entry], laboratory: Laboratory, models: Path, records: Path
) -> list[str]:
    """
    Put the best seed of each shipped row into models/; return a line about each.

    :param entries: rows whose seeds are trained.
    :param laboratory: that trained them.
    :param models: folder of the models.
    :param records: folder of records, which get the measurements behind the choice.
    """
    shipped = [entry for entry in entries if entry.row.shipped]
    choices = [
        Request(entry.row, seed, (choice_cases(entry),))
        for entry in shipped
        for seed in range(entry.seeds)
    ]
    laboratory.provide(choices)
    for choice in choices:
        laboratory.publish(choice, records)
    chosen = [(entry, best_seed(entry, laboratory)) for entry in shipped]
    chosen = [each for each in chosen if not is_there(*each, laboratory, models)]
    laboratory.provide(Request(entry.row, seed, card_cases(entry)) for entry, seed in chosen)
    return [copy_run(entry, seed, laboratory, models) for entry, seed in chosen]


def is_there(entry: Entry, seed: int, laboratory: Laboratory, models: Path) -> bool:
    """
    Return whether models/ has the weights of a run.

    :param entry: of its row.
    :param seed: of the run.
    :param laboratory: that trained it.
    :param models: folder of the models.
    """
    folder = models / entry.row.name
    if not (folder / WEIGHTS).is_file():
        return False
    return checkpoint_digest(folder) == laboratory.training(entry.row, seed).weights


def choice_cases(entry: Entry) -> Cases:
    """
    Return the cases by which the seed is chosen.

    :param entry: of the row.
    """
    return Cases(entry.row.tests[-1], LOOKAHEAD, 'validation', CHOICE_EPISODES)


def card_cases(entry: Entry) -> tuple[Cases, ...]:
    """
    Return the cases that the model card tells of.

    :param entry: of the row.
    """
    return tuple(Cases(test, LOOKAHEAD, episodes=CARD_EPISODES) for test in entry.row.tests)


def best_seed(entry: Entry, laboratory: Laboratory) -> int:
    """
    Return the seed with most successes on validation; among equals the faster one.

    :param entry: of the row.
    :param laboratory: that measured them.
    """

    def merit(seed: int) -> tuple[int, float]:
        found = laboratory.measurement(entry.row, seed, choice_cases(entry))
        return int(found.success.sum()), -mean_time(found)

    return max(range(entry.seeds), key=merit)


def mean_time(measurement: Measurement) -> float:
    """
    Return the mean time of successes, s; infinite without any.

    :param measurement: of a run.
    """
    times = measurement.time[measurement.success]
    return float(np.mean(times)) if len(times) else float('inf')


def copy_run(entry: Entry, seed: int, laboratory: Laboratory, models: Path) -> str:
    """
    Put a run into models/ and return a line about it.

    :param entry: of its row.
    :param seed: of the run.
    :param laboratory: that trained it.
    :param models: folder of the models.
    """
    run, folder = laboratory.run(entry.row, seed), models / entry.row.name
    summaries = [
        laboratory.measurement(entry.row, seed, cases).summary for cases in card_cases(entry)
    ]
    # By the scenario's own name, as `evaluate --card` does: curriculum-2.0 is called curriculum-2.
    metrics = {each['scenario']: each | {'model': entry.row.name} for each in summaries}
    folder.mkdir(parents=True, exist_ok=True)
    for name in (CONFIG, CSV_NAME, WEIGHTS):
        shutil.copyfile(run / name, folder / name)
    text = json.dumps(dict(sorted(metrics.items())), indent=2)
    atomic_write(folder / METRICS_NAME, f'{text}\n'.encode())
    write_model_card(folder)
    rates = ', '.join(f'{name} {each["success_rate"]:.4f}' for name, each in metrics.items())
    return f'{folder}: seed {seed} of {entry.seeds}; success {rates}'
