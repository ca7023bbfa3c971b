"""Laws of parameters that are for another node: as rclpy reads them, and said."""

from pathlib import Path
import signal

from helpers.faults import FAULTS
import pytest
import rclpy
from rclpy.context import Context
from rclpy.node import Node
import yaml

from socialnav.parameters.addressees import is_meant, unheard

NAMES = (
    'policy_node', '/policy_node', '/robot/policy_node', '/robot/arm/policy_node', '/**', '**',
    '/**/policy_node', '/*', '/*/policy_node', '/*/*', '/robot/**', '/robot/*/policy_node',
    '/robot/**/policy_node', 'policy', 'policy_node_2',
)  # fmt: skip
NAMESPACES = ('', 'robot', 'robot/arm')


def written(path: Path, name: str) -> Path:
    """Write a file of parameters for a node."""
    path.write_text(yaml.dump({name: {'ros__parameters': {'max_speed': 0.3}}}))
    return path


def rclpy_hears(path: Path, namespace: str) -> bool:
    """Return whether rclpy takes a parameter of a file for a node in a namespace."""
    context = Context()
    rclpy.init(args=['--ros-args', '--params-file', str(path)], context=context)
    node = Node('policy_node', namespace=namespace, context=context)
    heard = 'max_speed' in node._parameter_overrides
    node.destroy_node()
    rclpy.try_shutdown(context=context)
    return heard


@pytest.mark.parametrize('namespace', NAMESPACES)
def test_a_file_tells_a_node_something_where_rclpy_says_so(tmp_path, namespace):
    node = f'/{namespace}/policy_node'.replace('//', '/')
    for number, name in enumerate(NAMES):
        path = written(tmp_path / f'{number}.yaml', name)
        complaints = unheard(['node', '--ros-args', '--params-file', str(path)], node)
        assert rclpy_hears(path, namespace) == (complaints == []), name


def test_namespaces_in_a_file_may_be_nested(tmp_path):
    path = tmp_path / 'nested.yaml'
    path.write_text(yaml.dump({'robot': {'policy_node': {'ros__parameters': {}}}}))
    arguments = ['node', '--ros-args', '--params-file', str(path)]
    assert unheard(arguments, '/robot/policy_node') == []
    (line,) = unheard(arguments, '/policy_node')
    assert '/robot/policy_node' in line and str(path) in line


def test_a_parameter_for_another_node_is_named_and_one_for_all_is_not():
    arguments = ['-p', 'no:1', '--ros-args', '-p', 'max_speed:=0.3', '-p', 'nobody:max_speed:=0.3']
    (line,) = unheard([*arguments, '--', '-p', 'no:2'], '/policy_node')
    assert '-p nobody:max_speed:=0.3 is for /nobody, not for /policy_node' in line
    assert unheard(['--ros-args', '-p', 'policy_node:max_speed:=0.3'], '/policy_node') == []
    assert not is_meant('/policy.node', '/policy_node')


@pytest.mark.parametrize('node', ['policy_node', 'simulator_node'])
def test_a_node_says_that_a_file_is_for_another_one(graph, tmp_path, node):
    path = written(tmp_path / 'other.yaml', 'policy_nod')
    process = graph.run(
        ['ros2', 'run', 'socialnav', node, '--ros-args', '--params-file', str(path)]
    )
    graph.wait(lambda: node in graph.node.get_node_names(), 'node')
    graph.kill(process, signal.SIGTERM)
    errors = process.communicate()[1]
    said = FAULTS['other node'].said.replace('policy_node', node)
    assert f'{path} is for /policy_nod, {said}' in errors
