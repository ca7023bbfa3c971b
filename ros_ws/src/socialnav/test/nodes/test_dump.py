"""What `ros2 param dump` writes can be loaded, and started from."""

import math
import subprocess

from helpers.driving import Drive
from helpers.managed import change_parameter, change_parameters, TEXT
from helpers.worlds import random_state
import pytest
from rcl_interfaces.srv import GetParameters
from rclpy.parameter import parameter_value_to_python
import yaml

from socialnav.parameters.declaring import updated
from socialnav.parameters.fields import entries
from socialnav.parameters.readme import KINDS

READ_ONLY = 'start_type_description_service'
"""The parameter of every node that rclpy lets nobody set, not even to what it is."""


def ros2_param(*arguments):
    """Return what a command of `ros2 param` prints, and its errors."""
    result = subprocess.run(
        ['ros2', 'param', *arguments], capture_output=True, text=True, timeout=60, check=True
    )
    return result.stdout, result.stderr


def dumped(node, path):
    """Write the parameters of a node into a file and return them."""
    path.write_text(ros2_param('dump', f'/{node}')[0])
    return yaml.safe_load(path.read_text())[f'/{node}']['ros__parameters']


def value_of(graph, node, name):
    """Return a parameter of a node."""
    request = GetParameters.Request(names=[name])
    return parameter_value_to_python(
        graph.ask(GetParameters, f'{node}/get_parameters', request).values[0]
    )


@pytest.mark.parametrize('node', KINDS)
def test_a_node_accepts_its_own_dump_while_it_runs(graph, tmp_path, node):
    graph.start(node)
    graph.wait(lambda: node in graph.node.get_node_names(), 'node')
    before = dumped(node, tmp_path / 'before.yaml')
    assert {entry.name for entry in entries(KINDS[node])} <= before.keys()
    accepted, refused = ros2_param('load', f'/{node}', str(tmp_path / 'before.yaml'))
    assert accepted.count('successful') == len(before) - 1
    assert [line for line in refused.splitlines() if READ_ONLY not in line] == []
    assert dumped(node, tmp_path / 'after.yaml') == before


def test_a_dump_with_another_value_changes_what_may_change_and_nothing_else(graph, tmp_path):
    drive, state, path = Drive(graph).start(), random_state(0), tmp_path / 'policy.yaml'
    drive.moves(state)
    values = dumped('policy_node', path)
    assert values['max_acceleration'] == math.inf
    values |= {'max_speed': 0.7, 'threads': 2, 'autostart': not values['autostart']}
    path.write_text(yaml.dump({'/policy_node': {'ros__parameters': values}}))
    refused = ros2_param('load', '/policy_node', str(path))[1].splitlines()
    assert sorted(line.split()[2] for line in refused) == ['autostart', READ_ONLY, 'threads']
    assert value_of(graph, 'policy_node', 'max_speed') == 0.7
    drive.moves(state)


def test_a_node_starts_from_a_dump(graph, tmp_path):
    path = tmp_path / 'policy.yaml'
    first = graph.start('policy_node', model='orca', max_speed=0.6, autostart=False)
    graph.wait(lambda: 'policy_node' in graph.node.get_node_names(), 'node')
    before = dumped('policy_node', path)
    graph.kill(first)
    graph.wait(lambda: 'policy_node' not in graph.node.get_node_names(), 'end of the node')
    graph.run(
        ['ros2', 'run', 'socialnav', 'policy_node', '--ros-args', '--params-file', str(path)]
    )
    graph.wait(lambda: 'policy_node' in graph.node.get_node_names(), 'node')
    assert dumped('policy_node', tmp_path / 'after.yaml') == before


def test_a_text_is_taken_for_a_number_only_where_it_is_one_and_one_is_wanted(graph):
    graph.start('policy_node', model='orca', autostart=False)
    assert change_parameter(graph, 'bounds', type=TEXT, string_value='7.5').successful
    assert value_of(graph, 'policy_node', 'bounds') == 7.5
    assert change_parameter(graph, 'bounds', type=TEXT, string_value='inf').successful
    assert value_of(graph, 'policy_node', 'bounds') == math.inf
    wrong = [('bounds', 'nan'), ('bounds', '-inf'), ('bounds', 'wide'), ('max_speed', 'inf')]
    assert not any(one.successful for one in change_parameters(graph, wrong))
    assert not change_parameter(graph, 'max_agents', type=TEXT, string_value='7').successful
    assert change_parameter(graph, 'model', type=TEXT, string_value='7').successful
    assert value_of(graph, 'policy_node', 'model') == '7'


def test_a_change_of_a_parameter_of_rclpy_changes_no_settings():
    settings = KINDS['policy_node']()
    assert updated(settings, []) == settings
