"""What tests see of a node from outside: it runs under a guard, as its only child."""

import contextlib
from pathlib import Path
import re
import signal
import subprocess
import time

DEADLINE = 60.0
"""Time in which a program must have begun, s."""
POLL = 0.002
"""Time between two looks, s: loading rclpy takes longer."""


def wait_until_loading(process: subprocess.Popen, name: str) -> None:
    """Wait until a program answers signals by itself, before it has loaded rclpy."""
    deadline = time.monotonic() + DEADLINE
    while not is_loading(process, name):
        assert time.monotonic() < deadline, f'{name} answers no signals while it is being loaded'
        time.sleep(POLL)


def is_loading(process: subprocess.Popen, name: str) -> bool:
    """Return whether a program answers SIGTERM by itself and has not loaded rclpy yet."""
    with contextlib.suppress(OSError, ValueError):  # the guard has not started it yet
        children = Path(f'/proc/{process.pid}/task/{process.pid}/children')
        (number,) = children.read_text().split()
        node = Path('/proc') / number
        _, *words = (node / 'cmdline').read_text().split('\0')
        begun = words and words[0].endswith(f'/{name}')  # not of the guard any more
        caught = re.search(r'^SigCgt:\s*(\w+)', (node / 'status').read_text(), re.MULTILINE)
        answers = int(caught[1], 16) >> signal.SIGTERM - 1 & 1
        return bool(begun and answers) and '_rclpy' not in (node / 'maps').read_text()
    return False
