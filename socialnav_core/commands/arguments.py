"""What several commands have in common: the parser and its options."""

import argparse
from collections.abc import Callable
import math
from pathlib import Path
from typing import Any, NoReturn

from socialnav_core.config.mapping import parse_assignments
from socialnav_core.config.ranges import shown
from socialnav_core.config.training import LARGEST_SEED

SPLITS = ('train', 'validation', 'test')
MODEL_HELP = 'folder of a checkpoint, name in models/, or a policy without network such as orca'


SEED = (0, LARGEST_SEED)
EPISODES = (1, 1_000_000)
CASE = (0, 2**32 - 1)
THREADS = (1, 1024)
JOBS = (1, 1024)
FARTHEST = 5.0
LONGEST_LINE = 600
"""Least and greatest numbers that options take; characters of a message."""


class CommandFailure(RuntimeError):
    """What kept a command from its end; told in one line."""


class Parser(argparse.ArgumentParser):
    """A parser that reports a mistake in one line."""

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f'{self.prog}: {one_line(message)}; see {self.prog} --help\n')


def one_line(message: object) -> str:
    """Return a message on one line without characters that a terminal would obey."""
    text = ' '.join(str(message).split())
    text = ''.join(one if one.isprintable() else ascii(one)[1:-1] for one in text)
    if len(text) <= LONGEST_LINE:
        return text
    return f'{text[: LONGEST_LINE - 100]} ... {text[-90:]}'


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


def add_cases_options(parser: argparse.ArgumentParser, several: bool = False) -> None:
    """
    Add the options that say which cases are meant.

    :param several: whether more than one world may be named.
    """
    parser.add_argument(
        '--scenario',
        required=True,
        nargs='+' if several else None,
        metavar='NAME',
        help='world, see socialnav scenarios; or a YAML file of one, as socialnav scenarios hard '
        'prints it',
    )
    parser.add_argument(
        '--seed', type=whole_number(*SEED), default=0, metavar='N', help='seed of the cases (0)'
    )
    parser.add_argument(
        '--split', choices=SPLITS, default='test', help='split of the cases (test)'
    )
    add_set_option(parser, 'scenario.time_limit=35')
    add_threads_option(parser)


def add_world_options(parser: argparse.ArgumentParser, several: bool = False) -> None:
    """
    Add the options that say which cases are run, and how.

    :param several: whether more than one world may be named.
    """
    add_cases_options(parser, several)
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
    parser.add_argument('--seed', type=whole_number(*SEED), metavar='N', help=f'seed of {seeded}')
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
        '--threads',
        type=whole_number(*THREADS),
        default=1,
        metavar='N',
        help='processor threads (1)',
    )


def add_overwrite_option(parser: argparse.ArgumentParser) -> None:
    """Add `--overwrite`."""
    parser.add_argument('--overwrite', action='store_true', help='replace what exists')


def whole_number(least: int, most: int) -> Callable[[str], int]:
    """Return what reads a whole number between two others, both allowed."""

    def read(text: str) -> int:
        """Return the number that a text holds."""
        digits = text.isascii() and text.isdecimal() and len(text) <= len(str(most))
        if not digits or not least <= int(text) <= most:
            raise argparse.ArgumentTypeError(
                f'{shown(text)} is no whole number from {least} to {most}'
            )
        return int(text)

    return read


def distance(text: str) -> float:
    """Return a number of metres as a safety space may have."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not 0 <= number <= FARTHEST:
        raise argparse.ArgumentTypeError(f'{shown(text)} is no distance from 0 to {FARTHEST:g} m')
    return number
