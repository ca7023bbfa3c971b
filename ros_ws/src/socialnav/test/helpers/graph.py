"""What tests see of the graph: a node of their own, and processes that they start."""

from collections.abc import Callable, Iterator
import contextlib
import os
from pathlib import Path
import signal
import subprocess
import time
from typing import Any

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import QoSProfile

from helpers.shared_memory import owned_files, remove
from socialnav.demo.children import command_line

DEADLINE = 60.0
"""Time that anything may take before a test fails, s."""
LIFETIME = 300.0
"""Time after which a process ends whatever became of the test, s."""
UNSEEN_MATCH = 0.3
"""Time that a server is given to hear of the reader of its answers, s."""


class Graph:
    """A node that collects messages, and the processes of a test."""

    def __init__(self) -> None:
        self.node = rclpy.create_node('probe')
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        self.processes: list[subprocess.Popen] = []
        self.living: list[subprocess.Popen] = []
        self.leftovers: set[Path] = set()

    def start(self, name: str, **parameters: object) -> subprocess.Popen:
        """Start a node of the package; it is killed at the end of the test at the latest."""
        return self.run(command_line(name, parameters))

    def run(
        self, command: list[str], log: Path | None = None, lifetime: float = LIFETIME
    ) -> subprocess.Popen:
        """
        Start a program; it is killed at the end of the test at the latest.

        :param log: file for its errors, which a pipe that nobody reads has no room for.
        :param lifetime: time after which it ends whatever became of the test, s.
        """
        with contextlib.ExitStack() as files:
            errors = files.enter_context(log.open('w')) if log else subprocess.PIPE
            process = subprocess.Popen(
                ['timeout', '-k', f'{DEADLINE:g}', f'{lifetime:g}', *command],
                stderr=errors, text=True, env=dict(os.environ), start_new_session=True,
            )  # fmt: skip
        if log:
            process.stderr = log.open()
        self.processes.append(process)
        self.living.append(process)
        return process

    def kill(self, process: subprocess.Popen, number: int = signal.SIGKILL) -> None:
        """Send a signal to a node; from now on it may die."""
        self.living.remove(process)
        if number == signal.SIGKILL:
            self.leftovers |= owned_files(process)
        kill(process, number)

    def listen(self, kind: type, topic: str, profile: QoSProfile | int = 1000) -> list:
        """Return a list that grows with every message of a topic."""
        messages: list = []
        self.node.create_subscription(kind, topic, messages.append, profile)
        return messages

    def wait(self, condition: Callable[[], Any], what: str, deadline: float = DEADLINE) -> Any:
        """Spin until a condition holds and return its value; fail when it takes too long."""
        end = time.monotonic() + deadline
        while not (value := condition()):
            assert time.monotonic() < end, f'no {what} within {deadline:g} s'
            for process in self.living:
                assert process.poll() is None, process.communicate()[1]
            self.executor.spin_once(timeout_sec=0.02)
        return value

    def spin(self, duration: float) -> None:
        """Spin for some time, to see that something does not happen."""
        end = time.monotonic() + duration
        while time.monotonic() < end:
            self.executor.spin_once(timeout_sec=0.02)

    def call(self, kind: type, name: str, request: Any) -> Any:
        """Call a service and return its response."""
        client = self.node.create_client(kind, name)
        self.wait(client.service_is_ready, f'service {name}')
        # the server may hear of the reader of its answers later, which nobody can see from here:
        # an answer that it sends before is lost
        self.spin(UNSEEN_MATCH)
        future = client.call_async(request)
        self.wait(future.done, f'response of {name}')
        return future.result()

    def ask(self, kind: type, name: str, request: Any) -> Any:
        """Call a service that changes nothing, again where the answer stays away."""
        client = self.node.create_client(kind, name)
        self.wait(client.service_is_ready, f'service {name}')
        end = time.monotonic() + DEADLINE
        while time.monotonic() < end:
            future = client.call_async(request)
            self.executor.spin_until_future_complete(future, timeout_sec=2.0)
            if future.done():
                return future.result()
        raise AssertionError(f'no response of {name} within {DEADLINE:g} s')

    def close(self) -> None:
        """Kill what was started and leave; whatever a test was about, nothing had a traceback."""
        for process in self.processes:
            self.leftovers |= owned_files(process)
            kill(process)
            process.wait()
        remove(self.leftovers)
        errors = ''.join(remaining_errors(process) for process in self.processes)
        self.executor.shutdown()
        self.node.destroy_node()
        assert 'Traceback' not in errors, errors


@contextlib.contextmanager
def open_graph() -> Iterator[Graph]:
    """Yield a node that listens and speaks, and starts others."""
    rclpy.init()
    graph = Graph()
    try:
        yield graph
        graph.close()
    finally:
        rclpy.try_shutdown()


def remaining_errors(process: subprocess.Popen) -> str:
    """Return what a process has printed as errors and nobody has read; close the pipe."""
    if process.stderr.closed:
        return ''
    with process.stderr as stream:
        return stream.read()


def kill(process: subprocess.Popen, number: int = signal.SIGKILL) -> None:
    """Send a signal to a node, not only to the guard around it."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, number)
