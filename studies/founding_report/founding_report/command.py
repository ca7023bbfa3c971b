"""`socialnav reproduce`: the founding report's tables and figures, with ours beside them."""

import argparse
import dataclasses
from pathlib import Path
import sys
from typing import Any

from socialnav_core.commands.arguments import add_command, JOBS, whole_number
from socialnav_core.config import ConfigError

EXAMPLES = """table2 --quick
table2 --jobs 2
table1 table3 attention --seeds 3 --jobs 16 --device cuda --ship
all --no-train"""

NAMES = ('table1', 'table2', 'table3', 'figure1', 'figure4', 'recipes', 'attention', 'schedulers')
ALL = 'all'
ROOT = Path(__file__).parents[3]
RESULTS = Path(__file__).parents[1] / 'results'


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Train and measure what is missing and write pages: the report beside our figures.'
    parser = add_command(commands, 'reproduce', run, summary, EXAMPLES)
    parser.add_argument(
        'names', metavar='NAME', nargs='+', choices=(*NAMES, ALL),
        help=f'{", ".join(NAMES)}; all for everything',
    )  # fmt: skip
    parser.add_argument(
        '--quick', action='store_true', help='a smoke run of minutes; writes to out/reproduce only'
    )
    parser.add_argument(
        '--seeds', type=whole_number(1, 1000), metavar='N',
        help='training seeds (10 or 3, by the table)',
    )  # fmt: skip
    parser.add_argument(
        '--jobs', type=whole_number(*JOBS), default=1, metavar='N',
        help='processes side by side (1)',
    )  # fmt: skip
    parser.add_argument(
        '--device', choices=('cpu', 'cuda'), default='cpu', help='where networks are trained (cpu)'
    )
    parser.add_argument(
        '--no-train', action='store_true', help='measure and write only; all must be trained'
    )
    parser.add_argument(
        '--recorded', action='store_true',
        help='take runs that are not here from results/records in place of training them',
    )  # fmt: skip
    parser.add_argument(
        '--ship', action='store_true', help='put the best seed of each row into models/'
    )
    parser.add_argument(
        '--out', type=Path, default=Path('out', 'reproduce'), metavar='DIR',
        help='folder of the runs (out/reproduce)',
    )  # fmt: skip


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from founding_report.experiments import EXPERIMENTS
    from founding_report.laboratory import Laboratory
    from founding_report.shipping import ship
    from founding_report.writing import write_results

    if given.quick and (given.ship or given.recorded):
        raise ConfigError('--quick learns nothing that could be shipped or was recorded')
    folder = given.out / 'quick' if given.quick else given.out
    results = folder / 'results' if given.quick else RESULTS
    records = RESULTS / 'records' if given.recorded else None
    laboratory = Laboratory(folder, given.jobs, given.device, given.quick, say, records)
    seeds = given.seeds or (1 if given.quick else None)
    names = NAMES if ALL in given.names else tuple(dict.fromkeys(given.names))
    experiments = [EXPERIMENTS[name].with_seeds(seeds) for name in names]
    try:
        provide(experiments, laboratory, not given.no_train)
        if given.ship:
            own = dataclasses.replace(laboratory, records=None)
            models, kept = ROOT / 'models', results / 'records'
            for line in ship(longest(experiments), own, models, kept, not given.no_train):
                print(line)
            # What had only a record may be trained now: page and model are of the same weights.
            provide(experiments, laboratory, not given.no_train)
    except KeyboardInterrupt:
        say('what was begun is saved; the same command goes on with it')
        raise
    for experiment in experiments:
        command = command_of(experiment.name, given)
        print(write_results(experiment, laboratory, results, command))


def provide(experiments: list[Any], laboratory: Any, train: bool) -> None:
    """
    Train and measure what is missing for some experiments.

    :param train: whether runs may be trained; otherwise all must be.
    """
    for source, some in groups(experiments, laboratory):
        source.provide((r for each in some for r in each.requests(source)), train)


def groups(experiments: list[Any], laboratory: Any) -> list[tuple[Any, list[Any]]]:
    """Return laboratories and the experiments each provides for: figures need the very runs."""
    from founding_report.experiments import FIGURES

    tables = [each for each in experiments if each.layout not in FIGURES]
    figures = [each for each in experiments if each.layout in FIGURES]
    return [(dataclasses.replace(laboratory, records=None), figures), (laboratory, tables)]


def longest(experiments: list[Any]) -> list[Any]:
    """Return the rows of some experiments, each with the most seeds that it has in any."""
    entries: dict[str, Any] = {}
    for entry in (entry for experiment in experiments for entry in experiment.entries):
        known = entries.setdefault(entry.row.name, entry)
        entries[entry.row.name] = dataclasses.replace(entry, seeds=max(entry.seeds, known.seeds))
    return list(entries.values())


def command_of(name: str, given: argparse.Namespace) -> str:
    """Return the command that makes a page again."""
    options = ['--quick'] if given.quick else []
    options += [f'--seeds {given.seeds}'] if given.seeds else []
    options += [f'--device {given.device}'] if given.device != 'cpu' else []
    return ' '.join(['socialnav reproduce', name, *options])


def say(line: str) -> None:
    """Write a line on stderr at once."""
    print(line, file=sys.stderr, flush=True)
