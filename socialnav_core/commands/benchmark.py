"""`socialnav benchmark`: how fast it is."""

import argparse
from collections.abc import Callable, Sequence
import dataclasses
from pathlib import Path
import platform
import sys
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_threads_option,
)
from socialnav_core.commands.choices import use_threads
from socialnav_core.commands.files import require_new, write_json
from socialnav_core.tables import NOTHING, text_table

EXAMPLES = """simulator
all --json out/benchmark.json"""

SUBJECTS = ('simulator', 'lookahead', 'training')
COLUMNS = ('measurement', 'ours', 'reference', 'ratio', 'details')


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Measure speed, in turns with a plain reference on the same machine.'
    parser = add_command(commands, 'benchmark', run, summary, EXAMPLES)
    parser.add_argument(
        'subject', nargs='?', choices=(*SUBJECTS, 'all'), default='all', help='(all)'
    )
    parser.add_argument('--json', type=Path, metavar='FILE', help='write all figures')
    add_overwrite_option(parser)
    add_threads_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.benchmarking.reference import load_reference

    require_new(given.json, given)
    use_threads(given)
    reference: Any = load_reference()
    if isinstance(reference, str):
        print(f'socialnav benchmark: {reference}', file=sys.stderr)
        reference = None
    measurements = []
    for subject in SUBJECTS if given.subject == 'all' else (given.subject,):
        measurements += measurers(reference)[subject]()
    print(as_table(measurements))
    results = [dataclasses.asdict(measurement) for measurement in measurements]
    write_json(given.json, {**machine(given.threads), 'measurements': results})


def measurers(reference: Any) -> dict[str, Callable[[], list[Any]]]:
    """Return what measures each subject."""
    from socialnav_core.benchmarking.lookahead import lookahead_measurements
    from socialnav_core.benchmarking.simulator import simulator_measurements
    from socialnav_core.benchmarking.training import training_measurements

    return {
        'simulator': lambda: simulator_measurements(reference),
        'lookahead': lambda: lookahead_measurements(reference),
        'training': training_measurements,
    }


def machine(threads: int) -> dict[str, Any]:
    """Return what the figures were measured on."""
    return {
        'processor': processor_name(),
        'python': platform.python_version(),
        'threads': threads,
    }


def processor_name() -> str:
    """Return the name of the processor as Linux knows it, elsewhere its kind."""
    information = Path('/proc/cpuinfo')
    lines = information.read_text().splitlines() if information.is_file() else []
    names = [line.partition(':')[2].strip() for line in lines if line.startswith('model name')]
    return names[0] if names else platform.machine()


def as_table(measurements: Sequence[Any]) -> str:
    """Return measurements as text in columns."""
    rows: list[tuple[str, ...]] = [COLUMNS]
    for each in measurements:
        details = ', '.join(
            f'{name.replace("_", " ")} {figure(value)}' for name, value in each.details.items()
        )
        reference = NOTHING if each.reference is None else figure(each.reference)
        ratio = NOTHING if each.ratio is None else f'{each.ratio:.0f}x'
        rows.append((each.name, f'{figure(each.value)} {each.unit}', reference, ratio, details))
    return text_table(rows)


def figure(value: float) -> str:
    """
    Return a number with three digits that count, all of those before the point.

    :param value: not negative.
    """
    return f'{value:,.0f}' if value >= 100 else f'{value:.3g}'
