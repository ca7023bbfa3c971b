"""Figures 1 and 4 of the report as pictures of our own cases."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from founding_report.experiments import Entry, Experiment, FREEZING
from founding_report.freezing import (
    Found,
    frozen_cases,
    LARGE,
    NEAR,
    play,
    STANDING_DISTANCE,
    STANDING_SECONDS,
    standing_since,
)
from founding_report.laboratory import Laboratory
from founding_report.markdown import LOOKAHEAD_LABELS
from founding_report.page import interpretation
from socialnav_core.policies.value.checkpoint import checkpoint_digest
from socialnav_core.storage import written_whole
from socialnav_core.tables import markdown_table
from socialnav_core.viewing.plots import plot_recordings
from socialnav_core.viewing.recording import summary

FROZEN_CASES = 2
NOT_FOUND = 'There is no such case among those that were searched.'


def draw_figure(
    experiment: Experiment, laboratory: Laboratory, results: Path, command: str, notes: Path
) -> tuple[str, dict[str, Any]]:
    """
    Write the picture of a figure; return its page and its values.

    :param results: folder of the picture.
    :param notes: a file of prose that is taken over where it exists.
    """
    find = freezing if experiment.layout == FREEZING else contrast
    found = find(experiment.entries, laboratory)
    picture = results / f'{experiment.name}.png'
    if found:
        moments = None if experiment.layout == FREEZING else attention_moments(found)
        with written_whole(picture) as temporary:
            plot_recordings([each.recording for each in found], temporary, moments)
    else:
        picture.unlink(missing_ok=True)
    sections = [
        f'# {experiment.title}\n\n{experiment.question}\n\n    {command}',
        f'![{experiment.title}]({picture.name})' if found else NOT_FOUND,
        shown(found),
        interpretation(notes),
        searched(experiment.entries, laboratory),
    ]
    values = {
        'name': experiment.name,
        'command': command,
        'smoke_run': laboratory.quick,
        'cases': [found_values(each, laboratory) for each in found],
    }
    return '\n\n'.join(section for section in sections if section) + '\n', values


def freezing(entries: Sequence[Entry], laboratory: Laboratory) -> list[Found]:
    """
    Return the first different cases in which a row freezes.

    :param entries: the row, alone.
    """
    (entry,) = entries
    found: dict[tuple[str, int], Found] = {}
    for cases in entry.cases(laboratory):
        for each in frozen_cases(entry.row, range(entry.seeds), cases, laboratory):
            found.setdefault((cases.scenario, each.recording.case_index), each)
            if len(found) == FROZEN_CASES:
                return list(found.values())
    return list(found.values())


def contrast(entries: Sequence[Entry], laboratory: Laboratory) -> list[Found]:
    """
    Return the first case in which the first row arrives and the second one freezes.

    :param entries: two rows, compared with the same training seed.
    """
    arriving, standing = entries
    seeds = range(min(arriving.seeds, standing.seeds))
    for cases in standing.cases(laboratory):
        for frozen in frozen_cases(standing.row, seeds, cases, laboratory):
            case = frozen.recording.case_index
            if laboratory.measurement(arriving.row, frozen.seed, cases).success[case]:
                return [play(arriving.row, frozen.seed, cases, case, laboratory), frozen]
    return []


def attention_moments(found: Sequence[Found]) -> list[int]:
    """
    Return for each episode the state in which the robot is nearest to where the last one stands.

    :param found: episodes of the same case; in the last one the robot stands still.
    """
    last = found[-1].recording
    place = last.robot_path[-1]
    nearest = [
        int(np.linalg.norm(each.recording.robot_path[:-1] - place, axis=-1).argmin())
        for each in found[:-1]
    ]
    return [*nearest, min(standing_since(last), len(last.states) - 2)]


def shown(found: Sequence[Found]) -> str:
    """Return what each part of the picture shows, empty where nothing was found."""
    if not found:
        return ''
    head = ['Model', 'Look-ahead', 'Case', 'End', 'Command']
    lines = [
        [
            each.recording.policy,
            LOOKAHEAD_LABELS[each.cases.lookahead],
            f'`{each.cases.scenario}`, split `{each.cases.split}`, seed 0, case '
            f'{each.recording.case_index}',
            summary(each.recording),
            f'`socialnav render {checkpoint_of(each)} {render_options(each)}`',
        ]
        for each in found
    ]
    return (
        'From left to right, with the training seed; numbers on the paths are seconds, fainter '
        'discs are earlier ones. Violet lines, where there are any, show the attention to each '
        'agent at one moment. The commands of the cases need the trained runs, which the command '
        'above leaves.\n\n'
        f'{markdown_table(head, lines)}'
    )


def checkpoint_of(found: Found) -> Path:
    """Return the folder of the weights that drove, where runs are kept if nothing else is said."""
    runs = Path('out', 'reproduce', 'runs')
    return found.cases.checkpoint(runs / found.row.run_name / f'seed-{found.seed}')


def render_options(found: Found) -> str:
    """Return the options of `socialnav render` that show a case as a moving picture."""
    case = found.recording.case_index
    name = f'{found.row.name}-{found.seed}-{found.cases.scenario}-{case}.gif'
    return (
        f'--scenario {found.cases.scenario} --seed 0 --case {case} '
        f'--lookahead {found.cases.lookahead} --no-screening --out {Path("out", "render", name)}'
    )


def searched(entries: Sequence[Entry], laboratory: Laboratory) -> str:
    """Return the section that says how the cases were found and how often time ran out."""
    head = ['Model', 'World', 'Look-ahead', 'Time-outs of each seed']
    lines = []
    for entry in entries:
        for cases in entry.cases(laboratory):
            found = [laboratory.measurement(entry.row, s, cases) for s in range(entry.seeds)]
            counts = ', '.join(str(int(each.timeout.sum())) for each in found)
            label = LOOKAHEAD_LABELS[cases.lookahead]
            lines.append([entry.row.label, f'`{cases.scenario}`', label, counts])
    return (
        f'## The search\n\nThe first cases are taken of {laboratory.episodes} (split `test`, seed '
        f'0), in the order of the table, in which the robot spends at least its last '
        f'{STANDING_SECONDS:g} s within {STANDING_DISTANCE:g} m of one place, at most {NEAR:g} m '
        f'from an obstacle with a radius of at least {LARGE:g} m. Actions are not screened.\n\n'
        f'{markdown_table(head, lines)}'
    )


def found_values(found: Found, laboratory: Laboratory) -> dict[str, Any]:
    """Return which case is shown, fit for JSON."""
    run = laboratory.run(found.row, found.seed)
    return {
        'row': found.row.name,
        'training_seed': found.seed,
        'weights': checkpoint_digest(found.cases.checkpoint(run)),
        'scenario': found.cases.scenario,
        'lookahead': found.cases.lookahead,
        'split': found.cases.split,
        'case_index': found.recording.case_index,
        'outcome': found.recording.outcome,
        'seconds': float(found.recording.times[-1]),
    }
