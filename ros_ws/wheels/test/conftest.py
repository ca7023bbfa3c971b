"""What all tests share: the folder under test on the path, and an isolated graph."""

from collections.abc import Iterator
from pathlib import Path
import sys

from graph_under_test import ISOLATION, Talker
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))


@pytest.fixture(scope='session', autouse=True)
def isolation() -> Iterator[None]:
    """Keep the tests' graph to themselves."""
    with pytest.MonkeyPatch.context() as patch:
        for name, value in ISOLATION.items():
            patch.setenv(name, value)
        yield


@pytest.fixture(scope='session')
def talker(isolation: None) -> Iterator[Talker]:
    """Yield a node that publishes; it is there for all tests."""
    talker = Talker()
    yield talker
    talker.close()
