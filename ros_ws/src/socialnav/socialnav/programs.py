"""The programs of this package, which a signal ends even while their modules are being loaded."""

from collections.abc import Callable
from importlib import import_module
import os
import signal
from types import FrameType

STOPPING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Signals that end a program; the last one comes when the terminal is closed."""
INTERRUPTED = 130
"""Exit code of the demo after a signal, as a shell has it."""


def demo() -> None:
    """Run the demo."""
    start('demo.run', INTERRUPTED)


def obstacle_node() -> None:
    """Run the obstacle node."""
    start('obstacle_node')


def policy_node() -> None:
    """Run the policy node."""
    start('policy_node')


def simulator_node() -> None:
    """Run the simulator node."""
    start('simulator_node')


def tracker_node() -> None:
    """Run the tracker node."""
    start('tracker_node')


def start(module: str, interrupted: int = 0) -> None:
    """
    Load a module of this package and run its main().

    Loading takes seconds, during which Python would answer Ctrl-C with a traceback. Nothing has
    been started by then, so that nothing is left behind by a process that just ends.

    :param interrupted: exit code after a signal that comes before main().
    """
    take_signals(lambda *_: os._exit(interrupted))
    # NumPy's other threads would wait for the next product by spinning: a whole core at 10 Hz
    os.environ.setdefault('OPENBLAS_NUM_THREADS', '1')
    import_module(f'{__package__}.{module}').main()


def take_signals(handler: Callable[[int, FrameType | None], object]) -> None:
    """Handle the signals that end a program; one that nohup has it ignore stays ignored."""
    for number in STOPPING:
        if number != signal.SIGHUP or signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, handler)
