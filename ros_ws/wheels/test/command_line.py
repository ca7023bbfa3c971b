"""The small ros2 as a process."""

from collections.abc import Mapping
import os
from pathlib import Path
import subprocess
import sys
import time

COMMAND = [sys.executable, str(Path(__file__).resolve().parents[1] / 'ros2.py')]
DEADLINE = 20.0
"""Time that a command may take, s."""


def ros2(*arguments: str, **variables: str) -> subprocess.CompletedProcess:
    """Run a command to its end."""
    return subprocess.run(
        [*COMMAND, *arguments], capture_output=True, text=True, timeout=DEADLINE,
        env=os.environ | variables,
    )  # fmt: skip


def start(*arguments: str, environment: Mapping[str, str] | None = None) -> subprocess.Popen:
    """Start a command that does not end by itself."""
    return subprocess.Popen(
        [*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env=environment,
    )  # fmt: skip


def output(*arguments: str) -> str:
    """Return what a command prints; it must succeed."""
    result = ros2(*arguments)
    assert result.returncode == 0, result.stderr
    assert result.stderr == ''
    return result.stdout


def refusal(*arguments: str, **variables: str) -> str:
    """Return the error of a command that must fail, without a traceback."""
    result = ros2(*arguments, **variables)
    assert result.returncode == 1, result.stdout
    assert result.stdout == ''
    assert 'Traceback' not in result.stderr
    return result.stderr.strip()


def wait_for_line(process: subprocess.Popen, beginning: str) -> str:
    """Return the first line with a beginning; fail when it does not come."""
    deadline = time.monotonic() + DEADLINE
    for line in process.stdout:
        if line.startswith(beginning):
            return line
        assert time.monotonic() < deadline, f'no line {beginning!r}'
    raise AssertionError(f'ended without {beginning!r}: {process.stderr.read()}')
