"""Nodes as processes of their own, that never outlive whoever started them."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
import ctypes
import os
from pathlib import Path
import signal
import subprocess
import time

from ament_index_python.packages import get_package_prefix

from socialnav.programs import STOPPING

PATIENCE = 5.0
"""Time that a process gets to end after each signal, s."""
PR_SET_PDEATHSIG = 1
"""Of prctl(2)."""

Nodes = dict[str, subprocess.Popen]


@contextmanager
def running_nodes(
    parameters: Mapping[str, Mapping[str, object]],
    environment: Mapping[str, str],
    topics: Mapping[str, Mapping[str, str]] | None = None,
) -> Iterator[Nodes]:
    """
    Start nodes of this package; stop them at the end, whatever happens.

    :param parameters: of each node, by the name of its executable.
    :param topics: other names of topics of a node, by the name of its executable.
    """
    nodes: Nodes = {}
    try:
        for name, values in parameters.items():
            command = command_line(name, values, (topics or {}).get(name, {}))
            nodes[name] = subprocess.Popen(
                command,
                env=dict(environment),
                start_new_session=True,
                preexec_fn=ending_with_parent(),
            )
        yield nodes
    finally:
        with undisturbed():
            stop(list(nodes.values()))


@contextmanager
def undisturbed() -> Iterator[None]:
    """Ignore the signals that end a program, so that an impatient user leaves no node behind."""
    handlers = {number: signal.signal(number, signal.SIG_IGN) for number in STOPPING}
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)


def ending_with_parent() -> Callable[[], None]:
    """
    Return what a child does first: ask the kernel for SIGTERM when its parent dies.

    A parent that is killed with -9 has no other way to end its children.
    """
    system, parent = ctypes.CDLL(None), os.getpid()  # looked up before the fork

    def ask() -> None:
        system.prctl(PR_SET_PDEATHSIG, ctypes.c_ulong(signal.SIGTERM))
        if os.getppid() != parent:  # it died before it was asked
            os._exit(1)

    return ask


def command_line(
    name: str, parameters: Mapping[str, object], topics: Mapping[str, str] | None = None
) -> list[str]:
    """
    Return how a node of this package is started, warnings and errors only.

    :param name: of its executable.
    :param topics: other names of its topics.
    """
    executable = Path(get_package_prefix('socialnav')) / 'lib' / 'socialnav' / name
    assignments = [f'{key}:={parameter_text(value)}' for key, value in parameters.items()]
    flags = [text for assignment in assignments for text in ('-p', assignment)]
    renamed = [f'{old}:={new}' for old, new in (topics or {}).items()]
    flags += [text for rule in renamed for text in ('-r', rule)]
    return [str(executable), '--ros-args', '--log-level', 'warn', *flags]


def parameter_text(value: object) -> str:
    """Return a bool, number or text as YAML, as the command line wants it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def stop(processes: list[subprocess.Popen]) -> None:
    """End processes, of which some may have ended: all are asked, then told, then killed."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        alive = [process for process in processes if process.poll() is None]
        for process in alive:
            process.send_signal(number)
        wait(alive, time.monotonic() + PATIENCE)


def wait(processes: list[subprocess.Popen], deadline: float) -> None:
    """Wait until processes have ended, or until a deadline on the monotonic clock, s."""
    for process in processes:
        try:
            process.wait(max(0.0, deadline - time.monotonic()))
        except subprocess.TimeoutExpired:
            return
