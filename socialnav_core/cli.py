"""The `socialnav` command."""

import argparse
from collections.abc import Iterator, Sequence
import contextlib
import errno
from importlib.metadata import entry_points
import os
import signal
import sys
from typing import Any

from socialnav_core import __version__
from socialnav_core.commands import (
    benchmark,
    bound,
    compare,
    crowds,
    evaluate,
    evaluate_prediction,
    export,
    grid,
    metrics,
    models,
    render,
    report,
    scenarios,
    settings,
    train,
    train_planner,
    train_prediction,
)
from socialnav_core.commands.arguments import CommandFailure, one_line, Parser
from socialnav_core.config import ConfigError
from socialnav_core.extras import MissingExtra
from socialnav_core.termination import terminated_like_interrupted

COMMANDS = (
    train, evaluate, compare, render, benchmark, models, metrics, scenarios, settings,
    train_planner, train_prediction, evaluate_prediction, bound, grid, export, crowds, report,
)  # fmt: skip
"""Modules with `add_parser`, which names the function that runs the command."""
OTHERS = 'socialnav.commands'
"""Entry points of other packages: each the name of a module like those of COMMANDS."""

FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)
"""What the system says of a disk that takes no more."""
FAILURE, USAGE, SIGNALLED = 1, 2, 128
"""Exit codes; that of a command ended by a signal is SIGNALLED and the signal's number."""
SIGNALS = {int(signal.SIGINT): 'interrupted', int(signal.SIGTERM): 'terminated'}


def main(arguments: Sequence[str] | None = None) -> int:
    """
    Run a command and return the exit code.

    0; 1 for a failure, 2 for a mistake in what was asked, 130 after Ctrl-C, 143 after SIGTERM.

    :param arguments: without the program's name; None for those of the process.
    """
    given = build_parser().parse_args(arguments)
    os.environ.setdefault('OMP_NUM_THREADS', str(getattr(given, 'threads', 1)))
    try:
        with terminated_like_interrupted(), named_output():
            given.run(given)
            sys.stdout.flush()
    except ConfigError as error:
        return complain(given, error, USAGE)
    except KeyboardInterrupt as error:
        number = error.args[0] if error.args else signal.SIGINT
        return complain(given, SIGNALS.get(number, 'stopped'), SIGNALLED + number)
    except MemoryError:
        return complain(given, 'there is not enough memory for that', FAILURE)
    except BrokenPipeError:  # the reader of a pipe, such as `head`, has gone
        discard_output()
        return FAILURE
    except expected_failures() as error:
        return complain(given, error, SIGNALLED + getattr(error, 'number', FAILURE - SIGNALLED))
    return 0


@contextlib.contextmanager
def named_output() -> Iterator[None]:
    """Let the error of a full disk name standard output, since files name themselves."""
    try:
        yield
    except OSError as error:
        if error.filename is not None or error.errno not in FULL:
            raise
        discard_output()
        raise OSError(error.errno, error.strerror, 'standard output') from error


def discard_output() -> None:
    """Let nothing more be written to standard output."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


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
        try:
            yield point.load()
        except ImportError as error:  # a package of another revision must not stop all others
            print(f'socialnav: no command {point.name}: {one_line(error)}', file=sys.stderr)


def expected_failures() -> tuple[type[Exception], ...]:
    """Return the errors that are told in one line; others are defects and keep their traceback."""
    from socialnav_core.policies import CheckpointError
    from socialnav_core.training import TrainingInterrupted

    return (
        CheckpointError, CommandFailure, FloatingPointError, MissingExtra, TrainingInterrupted,
        OSError,
    )  # fmt: skip


def complain(given: argparse.Namespace, error: object, code: int) -> int:
    """Write one line on stderr and return the exit code."""
    print(f'socialnav {given.command}: {one_line(error)}', file=sys.stderr)
    return code


if __name__ == '__main__':
    sys.exit(main())
