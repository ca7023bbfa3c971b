"""The commands of the README are tried on the nodes, as they stand there."""

from pathlib import Path
import re
import shlex
import subprocess

from geometry_msgs.msg import PoseStamped
from helpers.graph import open_graph
import pytest

from socialnav import qos

README = (Path(__file__).parents[2] / 'README.md').read_text()
POLICY, SIMULATOR = '/policy_node', '/simulator_node'


@pytest.fixture(scope='module')
def nodes():
    """Keep both nodes running."""
    with open_graph() as graph:
        graph.start('simulator_node')
        graph.start('policy_node', model='orca', bounds=7.5)
        names = {POLICY, SIMULATOR}
        graph.wait(lambda: names <= {f'/{one}' for one in graph.node.get_node_names()}, 'nodes')
        yield graph


def ros2(*arguments):
    """Return what a command prints; it must succeed."""
    result = subprocess.run(
        ['ros2', *arguments], capture_output=True, text=True, timeout=60, check=False
    )
    assert result.returncode == 0, result.stderr
    return result.stdout


def of_readme(beginning):
    """Return the arguments of the command of the README that begins so."""
    (line,) = re.findall(rf'^ros2 {beginning}.*$', README, re.MULTILINE)
    return shlex.split(line, comments=True)[1:]


def test_the_description_of_a_parameter_has_its_meaning_unit_and_range(nodes):
    text = ros2(*of_readme('param describe'))
    for part in (
        'Parameter name: input_timeout', 'Type: double',
        'age of odom or pedestrians at which the robot stops [s]',
        'Min value: 0.05', 'Max value: 10.0',
    ):  # fmt: skip
        assert part in text


def test_an_episode_can_be_started_and_says_so(nodes):
    assert "success=True, message='case 3 has begun'" in ros2(*of_readme('service call'))


def test_commands_can_be_heard(nodes):
    text = ros2(*of_readme('topic echo'), '--once')
    assert text.startswith('linear:\n  x: ') and 'angular:\n' in text and text.endswith('---\n')


def test_a_goal_can_be_given(nodes):
    goals = nodes.listen(PoseStamped, 'goal_pose', qos.GOAL)
    assert 'publishing #1: geometry_msgs.msg.PoseStamped(' in ros2(*of_readme('topic pub'))

    def taken(goal):
        place, stamp = goal.pose.position, goal.header.stamp
        return (place.x, place.y) == (2.0, 1.0) and stamp.sec > 0

    nodes.wait(lambda: sum(map(taken, goals)) >= 2, 'goal of the operator and of the simulator')


def test_a_node_tells_what_it_offers_and_a_topic_who_uses_it(nodes):
    text = ros2('node', 'info', POLICY)
    assert '/cmd_vel: geometry_msgs/msg/Twist\n' in text
    assert '/policy_node/cancel_goal: std_srvs/srv/Trigger\n' in text
    text = ros2('topic', 'info', '-v', '/cmd_vel')
    assert 'Type: geometry_msgs/msg/Twist\n' in text and 'Node name: policy_node\n' in text
    assert 'Reliability: RELIABLE\n' in text


def test_the_state_can_be_read_and_changed(nodes):
    assert ros2('lifecycle', 'get', POLICY) == 'active [3]\n'
    assert ros2(*shlex.split('lifecycle set /policy_node deactivate')) == (
        'Transitioning successful\n'
    )
    assert ros2('lifecycle', 'get', POLICY) == 'inactive [2]\n'
    assert '`ros2 lifecycle set /policy_node deactivate`' in README
