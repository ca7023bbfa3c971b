"""Laws of `ros2 lifecycle`, with a managed node of the tests' own."""

from collections.abc import Iterator
from pathlib import Path
import subprocess
import sys

from command_line import DEADLINE, output, refusal, wait_for_line
from graph_under_test import Talker
import pytest

NAME = '/crowd/robot'
PROGRAM = Path(__file__).with_name('managed_robot.py')


@pytest.fixture(scope='module', autouse=True)
def robot(talker: Talker) -> Iterator[None]:
    """Keep a managed node beside the talker."""
    with subprocess.Popen(
        [sys.executable, str(PROGRAM)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        wait_for_line(process, 'ready')
        yield
        process.terminate()
        process.wait(timeout=DEADLINE)


def test_nothing_but_managed_nodes_is_listed() -> None:
    assert output('lifecycle', 'nodes') == f'{NAME}\n'


def test_a_transition_leads_to_its_state() -> None:
    assert output('lifecycle', 'set', NAME, 'configure') == 'Transitioning successful\n'
    assert output('lifecycle', 'get', NAME) == 'inactive [2]\n'


def test_a_transition_that_the_state_does_not_have_is_refused_with_those_that_it_has() -> None:
    lines = refusal('lifecycle', 'set', NAME, 'fly').splitlines()
    assert lines[0] == 'Unknown transition requested, available ones are:'
    assert '- shutdown [5]' in lines or '- shutdown [6]' in lines
