"""Tests run over the real middleware, in a domain of their own."""

from collections.abc import Iterator
import os

from graph import Graph
import pytest
import rclpy

from socialnav.isolation import isolated_environment

os.environ.update(isolated_environment(os.environ))


@pytest.fixture
def graph() -> Iterator[Graph]:
    """Yield a node that listens and speaks, and starts others."""
    rclpy.init()
    graph = Graph()
    yield graph
    graph.close()
    rclpy.try_shutdown()
