"""Laws of the policy node where nav2 is not installed."""

from importlib.util import find_spec

from helpers.managed import change_parameters, change_state
import pytest

from socialnav.demo.children import command_line
from socialnav.nav2.interface import ABSENT


@pytest.mark.skipif(find_spec('nav2_msgs') is not None, reason='nav2_msgs is installed')
def test_that_is_said_and_goals_must_come_from_topics(graph, tmp_path):
    command, log = command_line('policy_node', {'model': 'straight_line'}), tmp_path / 'log'
    graph.run([*command, '--log-level', 'info'], log=log)
    graph.wait(lambda: ABSENT in log.read_text(), 'word of the missing action')
    assert change_state(graph, 'deactivate') and change_state(graph, 'cleanup')
    assert change_parameters(graph, [('goal_topics', False)])[0].successful
    assert not change_state(graph, 'configure')
    graph.wait(lambda: 'nobody can give the robot a goal' in log.read_text(), 'refusal')
