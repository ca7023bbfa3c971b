"""Writes the page, the figures as JSON and the pictures of a table or figure."""

from collections.abc import Sequence
import dataclasses
import json
from pathlib import Path
from typing import Any

from founding_report import experiments, records
from founding_report.experiments import Experiment
from founding_report.laboratory import Laboratory
from founding_report.page import table_page
from founding_report.paired import paired_differences, PairedDifference
from founding_report.report_figures import reported
from founding_report.rows import Row
from founding_report.runs import Training
from founding_report.summary import FIGURES, seed_interval, summarise, Summary
from socialnav_core.storage import atomic_write


def write_results(
    experiment: Experiment, laboratory: Laboratory, results: Path, command: str
) -> Path:
    """
    Write the page of a table or figure and return its file.

    :param results: folder of the pages.
    """
    results.mkdir(parents=True, exist_ok=True)
    notes = results / 'notes' / f'{experiment.name}.md'
    if experiment.layout in experiments.FIGURES:
        from founding_report.figures import draw_figure

        text, values = draw_figure(experiment, laboratory, results, command, notes)
    else:
        summaries = [s for entry in experiment.entries for s in summarise(entry, laboratory)]
        differences = paired_differences(summaries, experiment.pairs)
        text = table_page(experiment, summaries, differences, laboratory, command, notes)
        values = table_values(experiment, summaries, differences, laboratory, command)
        for request in experiment.requests(laboratory):
            laboratory.publish(request, results / records.FOLDER)
    data = json.dumps(values, indent=1, allow_nan=False)
    atomic_write(results / f'{experiment.name}.json', f'{data}\n'.encode())
    page = results / f'{experiment.name}.md'
    atomic_write(page, text.encode())
    return page


def table_values(
    experiment: Experiment,
    summaries: Sequence[Summary],
    differences: Sequence[PairedDifference],
    laboratory: Laboratory,
    command: str,
) -> dict[str, Any]:
    """Return all figures of a table as plain values, fit for JSON."""
    return {
        'name': experiment.name,
        'command': command,
        'cases': {'split': 'test', 'seed': 0, 'episodes': laboratory.episodes},
        'screening': False,
        'smoke_run': laboratory.quick,
        'training': [
            training_values(entry.row, seed, laboratory.training(entry.row, seed))
            for entry in experiment.entries
            for seed in range(entry.seeds)
        ],
        'results': [summary_values(summary) for summary in summaries],
        'differences': [difference.to_mapping() for difference in differences],
    }


def summary_values(summary: Summary) -> dict[str, Any]:
    """Return the figures of a row in a scenario, the report's beside ours."""
    theirs = reported(summary.row.name, summary.scenario)
    estimates = {figure: summary.estimate(figure) for figure in FIGURES}
    return {
        'row': summary.row.name,
        'label': summary.row.label,
        'scenario': summary.scenario,
        'lookahead': summary.lookahead,
        'report': dataclasses.asdict(theirs) if theirs else None,
        'means': {name: dataclasses.asdict(e) if e else None for name, e in estimates.items()},
        'seeds': [
            {'training_seed': seed, 'success_interval': list(seed_interval(measurement)),
             **measurement.summary}
            for seed, measurement in zip(summary.seeds, summary.measurements, strict=True)
        ],
    }  # fmt: skip


def training_values(row: Row, seed: int, training: Training) -> dict[str, Any]:
    """Return how a run was trained."""
    last = training.progress
    return {
        'row': row.name,
        'run': row.run_name,
        'seed': seed,
        'weights': training.weights,
        'seconds': last['seconds'],
        'processor_seconds': last['processor_seconds'],
        'episodes': int(last['episodes']),
        'decisions': int(last['decisions']),
        'obstacle_radius': last['obstacle_radius'],
        'machine': training.machine,
    }
