"""Tests run over the real middleware, in a domain of their own."""

from collections.abc import Iterator
import os

from helpers import stops
from helpers.controllers import Recorder
from helpers.graph import Graph, open_graph
import pytest

from socialnav.demo.isolation import isolated_environment

os.environ.update(isolated_environment(os.environ))


@pytest.fixture
def graph() -> Iterator[Graph]:
    """Yield a node that listens and speaks, and starts others."""
    with open_graph() as graph:
        yield graph


@pytest.fixture
def policy() -> Recorder:
    """Return a policy that keeps what it saw and drives east."""
    return Recorder()


@pytest.fixture(params=[1, *(pytest.param(n, marks=pytest.mark.slow) for n in range(2, 6))])
def repetition(request: pytest.FixtureRequest) -> int:
    """Repeat what must never go wrong: once in a short run, five times in a long one."""
    return request.param


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Tell how soon robots were stopped."""
    for lines in (stops.table(), *(text.splitlines() for text in stops.measured)):
        if lines:
            terminalreporter.section('stop times')
            terminalreporter.write_line('\n'.join(lines))
