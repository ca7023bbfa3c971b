"""A page of results, made of the measurements alone."""

from collections.abc import Sequence
import math
from pathlib import Path

from founding_report import runs
from founding_report.experiments import Experiment
from founding_report.laboratory import Laboratory
from founding_report.markdown import (
    estimate_text,
    LOOKAHEAD_LABELS,
    number,
    p_value,
)
from founding_report.paired import PairedDifference
from founding_report.report_tables import report_has_any, report_table, verdict_table
from founding_report.summary import FIGURES, seed_interval, Summary
from socialnav_core.tables import markdown_table, NOTHING

LEVEL = 0.05
"""Below it, a difference of a seed is called one."""
FIGURE_COLUMNS = ('Success', 'Collision', 'Time-out', 'Time (s)')


def table_page(
    experiment: Experiment,
    summaries: Sequence[Summary],
    differences: Sequence[PairedDifference],
    laboratory: Laboratory,
    command: str,
    notes: Path,
) -> str:
    """
    Return the page of a table.

    :param command: that makes the page.
    :param notes: a file of prose that is taken over where it exists.
    """
    sections = [
        opening(experiment, command, laboratory),
        *(comparison(experiment, summaries) if report_has_any(summaries) else ()),
        interpretation(notes),
        intervals(summaries),
        paired(differences),
        every_seed(summaries),
        training(experiment, laboratory),
        f'## What is new\n\n{experiment.new}',
        f'## Deviations\n\n{experiment.deviations}',
    ]
    return '\n\n'.join(section for section in sections if section) + '\n'


def opening(experiment: Experiment, command: str, laboratory: Laboratory) -> str:
    """Return title, question, conditions and command."""
    smoke = '\n\nThis is a smoke run: nothing was learned.' if laboratory.quick else ''
    return (
        f'# {experiment.title}\n\n{experiment.question}\n\n'
        f'Measured on {laboratory.episodes} frozen cases (split `test`, seed 0), each run exactly '
        'once, without screening of actions. Collisions include leaving the walls; times are '
        'means over successes. The oracle look-ahead knows the next step of the people, as in the '
        'report; constant velocity is what a robot can use.\n\n'
        f'    {command}{smoke}'
    )


def comparison(experiment: Experiment, summaries: Sequence[Summary]) -> tuple[str, str]:
    """Return the sections that set the report's figures beside ours and judge each of them."""
    return (
        f"## The report's figures and ours\n\n{report_table(experiment, summaries)}",
        '## Verdicts\n\nOur mean over the training seeds against the figure of the report; its '
        f"interval is Wilson's at its 500 cases.\n\n{verdict_table(summaries)}",
    )


def interpretation(notes: Path) -> str:
    """Return the prose that people wrote about the results, empty where there is none."""
    if not notes.is_file():
        return ''
    return f'## Interpretation\n\n{notes.read_text(encoding="utf-8").strip()}'


def intervals(summaries: Sequence[Summary]) -> str:
    """Return the section with the means over seeds and their intervals."""
    head = [
        'Model',
        'World',
        'Look-ahead',
        'Seeds',
        'Success',
        'Collision',
        'Time-out',
        'Time (s)',
    ]
    lines = [
        [each.row.label, f'`{each.scenario}`', LOOKAHEAD_LABELS[each.lookahead],
         str(len(each.seeds)),
         *(estimate_text(each.estimate(figure), figure) for figure in FIGURES)]
        for each in summaries
    ]  # fmt: skip
    return (
        '## Means over training seeds\n\n95 % intervals of a bootstrap that draws seeds and '
        f'cases; with one seed they speak of the cases alone.\n\n{markdown_table(head, lines)}'
    )


def paired(differences: Sequence[PairedDifference]) -> str:
    """Return the section with the differences on the same cases."""
    if not differences:
        return ''
    head = ['First', 'Second', 'World', 'Look-ahead', 'Seeds', 'Success, first - second',
            'Only first : only second', 'Seeds better : worse',
            f'Better : worse at p < {LEVEL} (Holm)', 'Least p (Holm)',
            'Time where both arrive (s)']  # fmt: skip
    lines = [
        [each.first.row.label, each.second.row.label, f'`{each.first.scenario}`',
         LOOKAHEAD_LABELS[each.first.lookahead], str(len(each.tests)),
         estimate_text(each.success, 'success', '+'), f'{each.pooled[0]} : {each.pooled[1]}',
         seeds_won(each), seeds_won(each, LEVEL), p_value(min(each.adjusted)),
         estimate_text(each.time, 'time', '+')]
        for each in differences
    ]  # fmt: skip
    count = sum(len(each.tests) for each in differences)
    return (
        '## Paired differences on the same cases\n\nIntervals: 95 %, bootstrap over the seeds '
        'that both have and the cases; with one seed: over cases alone. Each seed of the first is '
        "tested against the same seed of the second by McNemar's exact test; the p-values are "
        f'adjusted for all {count} tests by Holm\'s method. "Better : worse" counts the seeds in '
        'which the first solves more cases and fewer, then those of them whose adjusted p is '
        f'below {LEVEL}.\n\n'
        f'{markdown_table(head, lines)}'
    )


def seeds_won(difference: PairedDifference, level: float = math.inf) -> str:
    """
    Return in how many seeds the first solved more cases than the second, and fewer.

    :param level: only seeds count whose adjusted p-value is smaller.
    """
    pairs = zip(difference.tests, difference.adjusted, strict=True)
    tests = [test for test, adjusted in pairs if adjusted < level]
    better = sum(test.first_only > test.second_only for test in tests)
    worse = sum(test.first_only < test.second_only for test in tests)
    return f'{better} : {worse}'


def every_seed(summaries: Sequence[Summary]) -> str:
    """Return the section with the figures of each seed."""
    head = ['Model', 'World', 'Look-ahead', 'Seed', *FIGURE_COLUMNS]
    lines = []
    for each in summaries:
        for seed, one in zip(each.seeds, each.measurements, strict=True):
            low, high = seed_interval(one)
            alone = Summary(each.row, each.scenario, each.lookahead, (seed,), (one,))
            success, *others = (number(alone.mean(figure), figure) for figure in FIGURES)
            lines.append(
                [each.row.label, f'`{each.scenario}`', LOOKAHEAD_LABELS[each.lookahead],
                 str(seed), f'{success} [{low:.3f}, {high:.3f}]', *others]
            )  # fmt: skip
    return f"## Every seed\n\n95 % intervals: Wilson's.\n\n{markdown_table(head, lines)}"


def training(experiment: Experiment, laboratory: Laboratory) -> str:
    """Return the section that says how the rows were trained and how long it took."""
    head = [
        'Model',
        'Run',
        'Configuration',
        'Seeds',
        'Minutes each',
        'Minutes of processor each',
        'Episodes each',
        'Trained on',
    ]
    lines = []
    for entry in experiment.entries:
        row = entry.row
        trained = [laboratory.training(row, seed) for seed in range(entry.seeds)]
        last = [each.progress for each in trained]
        settings = runs.assignment_texts(row.settings)
        lines.append(
            [row.label, f'`{row.run_name}`', f'`{" ".join([row.config, *settings])}`',
             str(entry.seeds), span([each['seconds'] / 60 for each in last], 1),
             span([each['processor_seconds'] / 60 for each in last], 1),
             span([each['episodes'] for each in last], 0), machines(trained)]
        )  # fmt: skip
    return (
        '## Training\n\nEach run is a process with one thread; minutes are of the wall clock, '
        'imitation included, on a machine that may have had other work; episodes are those of '
        'value learning.\n\n'
        f'{markdown_table(head, lines)}'
    )


def machines(trained: Sequence[runs.Training]) -> str:
    """Return where runs were trained."""
    found = {
        f'{values["device"]} ({values["name"]}, {values["jobs"]} runs side by side, torch '
        f'{values["torch"]})'
        for values in (each.machine for each in trained)
        if values
    }
    return '; '.join(sorted(found)) or NOTHING


def span(values: Sequence[float], digits: int) -> str:
    """
    Return the least and the greatest value, or the only one.

    :param digits: after the point.
    """
    low, high = f'{min(values):,.{digits}f}', f'{max(values):,.{digits}f}'
    return low if low == high else f'{low} - {high}'
