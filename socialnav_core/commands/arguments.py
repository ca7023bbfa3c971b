"""What several commands have in common: the parser and its options."""

import argparse
from collections.abc import Callable
import math
from pathlib import Path
from typing import Any, NoReturn

from socialnav_core.config.mapping import parse_assignments

SPLITS = ('train', 'validation', 'test')
MODEL_HELP = 'folder of a checkpoint, name in models/, or a policy without network such as orca'


class CommandFailure(RuntimeError):
    """What kept a command from its end; told in one line."""


class Parser(argparse.ArgumentParser):
    """A parser that reports a mistake in one line."""

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f'{self.prog}: {message}; see {self.prog} --help\n')


def add_command(
    commands: Any,
    name: str,
    run: Callable[[argparse.Namespace], None],
    summary: str,
    examples: str,
) -> argparse.ArgumentParser:
    """
    Add a command and return its parser.

    :param commands: what `add_subparsers` returned.
    :param examples: lines to type, without `socialnav` and the command's name.
    """
    lines = [f'  socialnav {name} {example}'.rstrip() for example in examples.splitlines()]
    parser = commands.add_parser(
        name,
        help=summary,
        description=summary,
        epilog='\n'.join(['examples:', *lines]),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.set_defaults(run=run, command=name)
    return parser


def add_cases_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that say which cases are meant."""
    parser.add_argument(
        '--scenario', required=True, metavar='NAME', help='world; see socialnav scenarios'
    )
    parser.add_argument(
        '--seed', type=whole_number, default=0, metavar='N', help='seed of the cases (0)'
    )
    parser.add_argument(
        '--split', choices=SPLITS, default='test', help='split of the cases (test)'
    )
    add_set_option(parser, 'scenario.time_limit=35')
    add_threads_option(parser)


def add_world_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that say which cases are run, and how."""
    add_cases_options(parser)
    parser.add_argument(
        '--lookahead',
        metavar='NAME',
        help='prediction of the pedestrians, such as constant_velocity or, in simulation only, '
        'oracle (the own setting of the model)',
    )
    parser.add_argument(
        '--screening',
        action=argparse.BooleanOptionalAction,
        help='mask unsafe actions (the own setting of the model)',
    )
    parser.add_argument(
        '--safety-space', type=distance, metavar='M',
        help='added to every radius by orca, m (0.15)',
    )  # fmt: skip


def add_set_option(parser: argparse.ArgumentParser, example: str) -> None:
    """
    Add `--set`.

    :param example: an assignment, for the help.
    """
    parser.add_argument(
        '--set',
        nargs='+',
        action='extend',
        default=[],
        metavar='KEY=VALUE',
        dest='assignments',
        help=f'change settings, such as {example}',
    )


def add_training_options(parser: argparse.ArgumentParser, example: str, seeded: str) -> None:
    """
    Add the options of a training: its config and changes to it, its folder and its seed.

    :param example: of a changed setting.
    :param seeded: what the seed is the seed of.
    """
    parser.add_argument(
        'config', metavar='CONFIG', help='YAML file, or the name of one that comes with socialnav'
    )
    add_set_option(parser, example)
    parser.add_argument('--out', type=Path, metavar='DIR', help='folder of the run (out/NAME)')
    parser.add_argument('--seed', type=whole_number, metavar='N', help=f'seed of {seeded}')
    parser.add_argument('--resume', action='store_true', help='go on with the run in the folder')
    add_overwrite_option(parser)
    add_threads_option(parser)


def training_assignments(given: argparse.Namespace) -> dict[str, Any]:
    """Return the changes to a config that were asked for, the seed among them."""
    assignments = parse_assignments(given.assignments)
    if given.seed is not None:
        assignments['seed'] = given.seed
    return assignments


def add_threads_option(parser: argparse.ArgumentParser) -> None:
    """Add `--threads`."""
    parser.add_argument(
        '--threads', type=positive_number, default=1, metavar='N', help='processor threads (1)'
    )


def add_overwrite_option(parser: argparse.ArgumentParser) -> None:
    """Add `--overwrite`."""
    parser.add_argument('--overwrite', action='store_true', help='replace what exists')


def positive_number(text: str) -> int:
    """Return a whole number of at least one."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f'{text!r} is no whole number of at least 1')
    return int(text)


def whole_number(text: str) -> int:
    """Return a whole number of at least zero."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f'{text!r} is no whole number of at least 0')
    return int(text)


def distance(text: str) -> float:
    """Return a finite number of at least zero."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not 0 <= number < math.inf:
        raise argparse.ArgumentTypeError(f'{text!r} is no distance of at least 0 m')
    return number
