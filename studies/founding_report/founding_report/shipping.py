"""The best seed of a row, with its measurements and card, into models/."""

from collections.abc import Sequence
import json
from pathlib import Path
from typing import Any

import numpy as np

from founding_report.experiments import Entry
from founding_report.laboratory import Laboratory, Request
from founding_report.measurements import Cases, Measurement
from socialnav_core.policies.value.checkpoint import (
    atomic_write,
    checkpoint_digest,
    CONFIG,
    load_checkpoint,
    WEIGHTS,
)
from socialnav_core.simulation import make_scenario
from socialnav_core.training import write_model_card
from socialnav_core.training.model_card import METRICS_NAME, read_metrics, result_key
from socialnav_core.training.progress import CSV_NAME

CARD_EPISODES = 5000
CHOICE_EPISODES = 500
LOOKAHEAD = 'constant_velocity'
ORACLE_TOO = ('sarl', 'gat4sn')
"""Rows whose cards have the oracle beside it, as in the report."""


def ship(
    entries: Sequence[Entry],
    laboratory: Laboratory,
    models: Path,
    records: Path,
    train: bool = True,
) -> list[str]:
    """
    Put the best seed of each shipped row into models/; return a line about each.

    :param laboratory: that trains them; without records, which have no weights.
    :param records: folder of records, which get the measurements behind the choice.
    :param train: whether runs may be trained; otherwise all must be.
    :raises ConfigError: when a run has other settings than its row, or may not be trained.
    """
    shipped = [entry for entry in entries if entry.row.shipped]
    choices = [
        Request(entry.row, seed, (choice_cases(entry),))
        for entry in shipped
        for seed in range(entry.seeds)
    ]
    laboratory.provide(choices, train)
    for choice in choices:
        laboratory.publish(choice, records)
    chosen = [(entry, best_seed(entry, laboratory)) for entry in shipped]
    missing = [each for each in chosen if not is_there(*each, laboratory, models)]
    laboratory.provide((Request(e.row, seed, card_cases(e)) for e, seed in missing), train)
    lines = [copy_run(entry, seed, laboratory, models) for entry, seed in missing]
    for entry in shipped:  # also where an earlier run was killed before it wrote the card
        folder = models / entry.row.name
        write_model_card(folder, load_checkpoint(folder))
    return lines


def is_there(entry: Entry, seed: int, laboratory: Laboratory, models: Path) -> bool:
    """Return whether models/ has the weights of a run and all results that its card needs."""
    folder = models / entry.row.name
    results = list(read_metrics(folder).values())
    complete = all(is_among(cases, results) for cases in card_cases(entry))
    return complete and has_weights(folder, laboratory.run(entry.row, seed))


def is_among(cases: Cases, results: Sequence[dict[str, Any]]) -> bool:
    """
    Return whether one of some results is of these cases, or of more of the same kind.

    :param results: as in metrics.json.
    """
    kind = (make_scenario(cases.scenario).name, cases.lookahead, cases.split, 0, False)
    names = ('scenario', 'lookahead', 'split', 'seed', 'screening')
    return any(
        tuple(result[name] for name in names) == kind and result['episodes'] >= cases.episodes
        for result in results
    )


def has_weights(folder: Path, run: Path) -> bool:
    """Return whether a model has the weights of a run."""
    return (folder / WEIGHTS).is_file() and checkpoint_digest(folder) == checkpoint_digest(run)


def choice_cases(entry: Entry) -> Cases:
    """Return the cases by which the seed is chosen."""
    return Cases(entry.row.tests[-1], LOOKAHEAD, 'validation', CHOICE_EPISODES)


def card_cases(entry: Entry) -> tuple[Cases, ...]:
    """Return the cases that the model card tells of."""
    lookaheads = (LOOKAHEAD, 'oracle') if entry.row.name in ORACLE_TOO else (LOOKAHEAD,)
    return tuple(
        Cases(test, lookahead, episodes=CARD_EPISODES)
        for test in entry.row.tests
        for lookahead in lookaheads
    )


def best_seed(entry: Entry, laboratory: Laboratory) -> int:
    """Return the seed with most successes on validation; among equals the faster one."""

    def merit(seed: int) -> tuple[int, float]:
        found = laboratory.measurement(entry.row, seed, choice_cases(entry))
        return int(found.success.sum()), -mean_time(found)

    return max(range(entry.seeds), key=merit)


def mean_time(measurement: Measurement) -> float:
    """Return the mean time of successes, s; infinite without any."""
    times = measurement.time[measurement.success]
    return float(np.mean(times)) if len(times) else float('inf')


def copy_run(entry: Entry, seed: int, laboratory: Laboratory, models: Path) -> str:
    """
    Put a run into models/ and return a line about it.

    Weights go first and come last: a model that was put there in part has none.
    """
    run, folder = laboratory.run(entry.row, seed), models / entry.row.name
    measured = card_results(entry, seed, laboratory)
    metrics = measured
    folder.mkdir(parents=True, exist_ok=True)
    if has_weights(folder, run):
        metrics = read_metrics(folder) | measured
    else:
        (folder / WEIGHTS).unlink(missing_ok=True)
    text = json.dumps(dict(sorted(metrics.items())), indent=2)
    atomic_write(folder / METRICS_NAME, f'{text}\n'.encode())
    for name in (CONFIG, CSV_NAME, WEIGHTS):
        atomic_write(folder / name, (run / name).read_bytes())
    write_model_card(folder, load_checkpoint(folder))
    rates = ', '.join(f'{name} {each["success_rate"]:.4f}' for name, each in measured.items())
    return f'{folder}: seed {seed} of {entry.seeds}; success {rates}'


def card_results(entry: Entry, seed: int, laboratory: Laboratory) -> dict[str, dict[str, Any]]:
    """Return what the model card tells of a run, by the keys of metrics.json."""
    config = entry.row.resolved(seed, quick=False)
    results = (
        laboratory.measurement(entry.row, seed, cases).summary for cases in card_cases(entry)
    )
    return {result_key(each, config): each | {'model': entry.row.name} for each in results}
