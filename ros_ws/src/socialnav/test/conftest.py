"""Tests run over the real middleware, in a domain of their own."""

from collections.abc import Iterator
import os

from graph import Graph, open_graph
import pytest

from socialnav.isolation import isolated_environment

os.environ.update(isolated_environment(os.environ))


@pytest.fixture
def graph() -> Iterator[Graph]:
    """Yield a node that listens and speaks, and starts others."""
    with open_graph() as graph:
        yield graph
