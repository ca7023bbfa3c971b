"""The `socialnav` command."""

import argparse
from collections.abc import Iterator, Sequence
from importlib.metadata import entry_points
import os
import sys
from typing import Any

from socialnav_core import __version__
from socialnav_core.commands import (
    benchmark,
    bound,
    compare,
    evaluate,
    evaluate_prediction,
    grid,
    metrics,
    models,
    render,
    scenarios,
    train,
    train_prediction,
)
from socialnav_core.commands.arguments import CommandFailure, Parser
from socialnav_core.config import ConfigError
from socialnav_core.extras import MissingExtra

COMMANDS = (
    train, evaluate, compare, render, benchmark, models, metrics, scenarios, train_prediction,
    evaluate_prediction, bound, grid,
)  # fmt: skip
"""Modules with `add_parser`, which names the function that runs the command."""
OTHERS = 'socialnav.commands'
"""Entry points of other packages: each the name of a module like those of COMMANDS."""

FAILURE, USAGE, INTERRUPTED = 1, 2, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """
    Run a command and return the exit code: 0, 1 for a failure, 2 for a mistake in what was asked.

    :param arguments: without the program's name; None for those of the process.
    """
    given = build_parser().parse_args(arguments)
    os.environ.setdefault('OMP_NUM_THREADS', str(getattr(given, 'threads', 1)))
    try:
        given.run(given)
    except ConfigError as error:
        return complain(given, error, USAGE)
    except KeyboardInterrupt:
        return complain(given, 'interrupted', INTERRUPTED)
    except BrokenPipeError:  # the reader of a pipe, such as `head`, has gone
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILURE
    except expected_failures() as error:
        return complain(given, error, FAILURE)
    return 0


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of all commands."""
    parser = Parser(
        prog='socialnav',
        description='Train, evaluate and watch robots that find their way among people.',
        epilog='`socialnav COMMAND --help` shows the options of a command and examples.',
    )
    parser.add_argument('--version', action='version', version=f'socialnav {__version__}')
    commands = parser.add_subparsers(metavar='COMMAND', required=True)
    for module in (*COMMANDS, *other_commands()):
        module.add_parser(commands)
    return parser


def other_commands() -> Iterator[Any]:
    """Yield the modules of commands that other installed packages add, by the commands' names."""
    for point in sorted(entry_points(group=OTHERS), key=lambda point: point.name):
        yield point.load()


def expected_failures() -> tuple[type[Exception], ...]:
    """Return the errors that are told in one line; others are defects and keep their traceback."""
    from socialnav_core.policies import CheckpointError
    from socialnav_core.training import TrainingInterrupted

    return (CheckpointError, CommandFailure, MissingExtra, TrainingInterrupted, OSError)


def complain(given: argparse.Namespace, error: object, code: int) -> int:
    """Write one line on stderr and return the exit code."""
    text = ' '.join(str(error).split())
    print(f'socialnav {given.command}: {text}', file=sys.stderr)
    return code


if __name__ == '__main__':
    sys.exit(main())
