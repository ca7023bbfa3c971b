"""Laws of what is launched and configured: launch files, parameter files, RViz."""

import ast
from importlib.util import find_spec
from pathlib import Path
import re
import signal
import subprocess

from ament_index_python.packages import get_package_prefix
from helpers.graph import DEADLINE
import pytest
import rclpy
from rclpy.context import Context
from rclpy.node import Node
import yaml

from socialnav.parameters.declaring import declare
from socialnav.parameters.fields import entries
from socialnav.parameters.policy import PolicyParameters
from socialnav.parameters.simulator import SimulatorParameters
from socialnav_core.simulation import make_scenario

PACKAGE = Path(__file__).parents[1]
LAUNCH_FILES = sorted((PACKAGE / 'launch').glob('*_launch.py'))
PARAMETERS = {
    entry.name for kind in (PolicyParameters, SimulatorParameters) for entry in entries(kind)
}
needs_launch = pytest.mark.skipif(
    find_spec('ros2launch') is None,
    reason='ros2 launch is not installed: no wheel has it',
)


def load(name):
    """Return a configuration file of the package."""
    return yaml.safe_load((PACKAGE / name).read_text())


def calls(path, name):
    """Return the arguments, by keyword, of each call of a function in a file."""
    tree = ast.parse(path.read_text(), path.name)
    found = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    found = [node for node in found if getattr(node.func, 'id', None) == name]
    return [{one.arg: one.value for one in call.keywords} for call in found]


def literal_keys(path, expression):
    """Return the keys of the dictionaries in an expression, and in those that it names."""
    names = {one.id for one in ast.walk(expression) if isinstance(one, ast.Name)}
    expressions = [expression]
    for one in ast.walk(ast.parse(path.read_text())):
        if isinstance(one, ast.Assign) and getattr(one.targets[0], 'id', None) in names:
            expressions.append(one.value)
    tables = [one for part in expressions for one in ast.walk(part) if isinstance(one, ast.Dict)]
    return {key.value for table in tables for key in table.keys if key is not None}


@pytest.mark.parametrize('path', LAUNCH_FILES, ids=lambda path: path.name)
def test_launch_files_name_only_executables_and_parameters_that_exist(path):
    installed = Path(get_package_prefix('socialnav')) / 'lib' / 'socialnav'
    own = [call for call in calls(path, 'Node') if call['package'].value == 'socialnav']
    assert own
    for call in own:
        assert (installed / call['executable'].value).is_file()
        keys = literal_keys(path, call['parameters'])
        assert keys
        assert keys <= PARAMETERS | {'use_sim_time'}


@pytest.mark.parametrize('namespace', ['', 'robot'])
def test_the_policy_accepts_every_parameter_of_its_file(namespace):
    (wanted,) = (one['ros__parameters'] for one in load('config/policy.yaml').values())
    context = Context()
    rclpy.init(
        args=['--ros-args', '--params-file', str(PACKAGE / 'config' / 'policy.yaml')],
        context=context,
    )
    node = Node('policy_node', namespace=namespace, context=context)
    settings = declare(node, PolicyParameters)
    node.destroy_node()
    rclpy.try_shutdown(context=context)
    assert {name: getattr(settings, name) for name in wanted} == wanted


def test_the_collision_monitor_brakes_what_the_policy_commands():
    monitor = load('config/collision_monitor.yaml')['collision_monitor']['ros__parameters']
    (policy,) = (one['ros__parameters'] for one in load('config/policy.yaml').values())
    assert (monitor['cmd_vel_in_topic'], monitor['cmd_vel_out_topic']) == (
        'cmd_vel_raw',
        'cmd_vel',
    )
    assert monitor['enable_stamped_cmd_vel'] == policy['enable_stamped_cmd_vel']
    assert monitor['base_frame_id'] == policy['base_frame']
    assert monitor['footprint']['radius'] >= policy['robot_radius']
    assert {*monitor['polygons'], *monitor['observation_sources']} <= monitor.keys()


def test_rviz_shows_topics_that_the_simulator_has():
    text = (PACKAGE / 'rviz' / 'socialnav.rviz').read_text()
    readme = (PACKAGE / 'README.md').read_text()
    assert yaml.safe_load(text)['Visualization Manager']['Global Options']['Fixed Frame'] == 'odom'
    topics = set(re.findall(r'Value: /(\S+)', text))
    assert topics == {'map', 'markers', 'odom', 'goal_pose'}
    assert all(f'| pub | `{topic}` |' in readme for topic in topics)


@pytest.mark.parametrize('path', LAUNCH_FILES, ids=lambda path: path.name)
def test_launch_files_need_no_package_but_those_of_ros(path):
    imports = [one for one in ast.walk(ast.parse(path.read_text())) if hasattr(one, 'module')]
    assert imports
    assert not any(one.module.startswith('socialnav_core') for one in imports)


def test_the_demo_keeps_to_the_bounds_of_its_scenario():
    text = (PACKAGE / 'launch' / 'demo_launch.py').read_text()
    scenario, bounds = (
        re.search(rf"\('{name}', '(\S+)'", text).group(1) for name in ('scenario', 'bounds')
    )
    assert float(bounds) == make_scenario(scenario).bounds


@needs_launch
@pytest.mark.parametrize(
    ('name', 'arguments', 'nodes'),
    [
        ('demo_launch.py', ['rviz:=false'], {'simulator_node', 'policy_node'}),
        ('policy_launch.py', ['cmd_vel:=cmd_vel_raw'], {'policy_node'}),
    ],
)
def test_launch_starts_the_nodes_and_stops_them(graph, name, arguments, nodes):
    process = subprocess.Popen(
        ['ros2', 'launch', 'socialnav', name, 'model:=orca', *arguments],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True,
    )  # fmt: skip
    graph.processes.append(process)
    graph.wait(lambda: nodes <= set(graph.node.get_node_names()), 'nodes')
    topic = 'cmd_vel_raw' if 'cmd_vel:=cmd_vel_raw' in arguments else 'cmd_vel'
    graph.wait(lambda: graph.node.count_publishers(topic), topic)
    process.send_signal(signal.SIGINT)
    process.wait(timeout=DEADLINE)
    graph.wait(lambda: not nodes & set(graph.node.get_node_names()), 'end of the nodes')
