"""Laws of nav2_launch.py and its parameters, as far as they hold without nav2 and launch."""

import importlib.util
from pathlib import Path
import sys
from types import ModuleType, SimpleNamespace

import pytest
import rclpy
from rclpy.context import Context
from rclpy.node import Node
import yaml

from socialnav.parameters.declaring import declare
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.parameters.policy import PolicyParameters
from socialnav.parameters.tracker import TrackerParameters

PACKAGE = Path(__file__).parents[1]
FILE = PACKAGE / 'config' / 'nav2_params.yaml'
OWN = {
    'controller_server': PolicyParameters,
    'obstacle_node': ObstacleParameters,
    'tracker_node': TrackerParameters,
}
KNOWN = {
    'map_server': 'yaml_filename topic_name frame_id',
    'planner_server': 'expected_planner_frequency costmap_update_timeout planner_plugins '
    'GridBased.plugin GridBased.tolerance GridBased.use_astar GridBased.allow_unknown',
    'global_costmap': 'update_frequency publish_frequency global_frame robot_base_frame '
    'robot_radius resolution track_unknown_space always_send_full_costmap plugins '
    'static_layer.plugin static_layer.map_subscribe_transient_local inflation_layer.plugin '
    'inflation_layer.cost_scaling_factor inflation_layer.inflation_radius',
    'behavior_server': 'local_costmap_topic local_footprint_topic global_costmap_topic '
    'global_footprint_topic local_frame global_frame robot_base_frame cycle_frequency '
    'transform_tolerance behavior_plugins spin.plugin backup.plugin drive_on_heading.plugin '
    'wait.plugin assisted_teleop.plugin simulate_ahead_time max_rotational_vel '
    'min_rotational_vel rotational_acc_lim enable_stamped_cmd_vel',
    'bt_navigator': 'global_frame robot_base_frame odom_topic bt_loop_duration '
    'default_server_timeout wait_for_service_timeout navigators navigate_to_pose.plugin '
    'navigate_through_poses.plugin error_code_names',
    'velocity_smoother': 'smoothing_frequency scale_velocities feedback max_velocity '
    'min_velocity max_accel max_decel deadband_velocity velocity_timeout odom_topic '
    'odom_duration enable_stamped_cmd_vel',
    'collision_monitor': 'base_frame_id odom_frame_id cmd_vel_in_topic cmd_vel_out_topic '
    'state_topic transform_tolerance source_timeout base_shift_correction stop_pub_timeout '
    'polygons footprint.type footprint.radius footprint.action_type '
    'footprint.time_before_collision footprint.simulation_time_step footprint.min_points '
    'footprint.visualize footprint.enabled observation_sources scan.type scan.topic '
    'scan.enabled enable_stamped_cmd_vel',
    'lifecycle_manager_navigation': 'bond_timeout node_names autostart',
}
"""Parameters that nav2's documentation has for its nodes in Jazzy, of those that are used here."""


def parameters():
    """Return the parameters of each node in the file."""
    content = yaml.safe_load(FILE.read_text())
    content['global_costmap'] = content['global_costmap']['global_costmap']
    return {name: node['ros__parameters'] for name, node in content.items()}


def flat(tree, way=''):
    """Yield the full names in a tree of parameters."""
    for name, value in tree.items():
        if isinstance(value, dict):
            yield from flat(value, f'{way}{name}.')
        else:
            yield f'{way}{name}'


@pytest.mark.parametrize('name', KNOWN)
def test_the_file_has_only_parameters_that_nav2_documents(name):
    assert set(flat(parameters()[name])) <= set(KNOWN[name].split())


def test_every_node_of_the_file_is_one_that_is_known():
    assert parameters().keys() == {*KNOWN, *OWN}


@pytest.mark.parametrize('name', OWN)
def test_the_nodes_of_this_package_accept_every_parameter_of_the_file(name):
    context, wanted = Context(), parameters()[name]
    rclpy.init(args=['--ros-args', '--params-file', str(FILE)], context=context)
    node = Node(name, context=context)
    settings = declare(node, OWN[name])
    node.destroy_node()
    rclpy.try_shutdown(context=context)
    assert wanted and {key: getattr(settings, key) for key in wanted} == wanted


def test_what_nodes_are_told_of_the_robot_agrees():
    told = parameters()
    policy, smoother, monitor, costmap, behaviors = (
        told[name] for name in ('controller_server', 'velocity_smoother', 'collision_monitor',
                                'global_costmap', 'behavior_server')
    )  # fmt: skip
    assert costmap['robot_radius'] == policy['robot_radius'] <= monitor['footprint']['radius']
    largest = [policy['max_speed'], policy['max_speed'], policy['max_turn_rate']]
    assert smoother['max_velocity'] == largest == [-one for one in smoother['min_velocity']]
    assert smoother['max_accel'][0] >= policy['max_acceleration']
    assert all(-slow > fast for slow, fast in zip(
        smoother['max_decel'], smoother['max_accel'], strict=True))  # fmt: skip
    assert behaviors['max_rotational_vel'] <= policy['max_turn_rate']
    for frame, keys in (
        ('base_link', ('base_frame', 'base_frame_id', 'robot_base_frame')),
        ('odom', ('planning_frame', 'odom_frame_id')),
    ):
        assert {one[key] for one in told.values() for key in keys if key in one} == {frame}


def test_nobody_but_the_manager_activates_the_policy_and_only_paths_give_it_goals():
    policy = parameters()['controller_server']
    assert not policy['autostart'] and not policy['goal_topics']
    assert policy['goal_yaw_tolerance'] < 1.0
    assert parameters()['bt_navigator']['error_code_names'][-1] == 'follow_path_error_code'


@pytest.fixture
def launch_file(monkeypatch):
    """Return the launch file, with stand-ins for launch that keep what they are told."""

    class Kept(SimpleNamespace):
        def __init__(self, *arguments, **options):
            super().__init__(arguments=arguments, **options)

    stand_ins = {
        'launch': ('LaunchContext', 'LaunchDescription'),
        'launch.action': ('Action',),
        'launch.actions': ('DeclareLaunchArgument', 'OpaqueFunction'),
        'launch_ros': (),
        'launch_ros.actions': ('Node',),
    }
    for name, classes in stand_ins.items():
        module = ModuleType(name)
        module.__dict__.update(dict.fromkeys(classes, Kept))
        monkeypatch.setitem(sys.modules, name, module)
    path = PACKAGE / 'launch' / 'nav2_launch.py'
    spec = importlib.util.spec_from_file_location('nav2_launch', path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def launched(launch_file, **changes):
    """Return the nodes that are launched, by their names."""
    values = {name: default for name, default, *_ in launch_file.ARGUMENTS} | changes
    nodes = launch_file.nodes(SimpleNamespace(launch_configurations=values))
    return {node.name: node for node in nodes}


def given(node):
    """Return what a node is told besides the file."""
    return {key: value for one in node.parameters[1:] for key, value in one.items()}


def test_the_manager_activates_every_managed_node_after_those_that_it_calls(launch_file):
    nodes = launched(launch_file, map='house.yaml')
    manager = given(nodes['lifecycle_manager_navigation'])
    others = {'obstacle_node', 'tracker_node', 'lifecycle_manager_navigation'}
    assert set(manager['node_names']) == nodes.keys() - others
    order = manager['node_names'].index
    for server in ('map_server', 'planner_server', 'controller_server', 'behavior_server'):
        assert order(server) < order('bt_navigator')
    assert manager['autostart'] is True


def test_the_policy_runs_under_the_name_of_controller_server(launch_file):
    policy = launched(launch_file)['controller_server']
    assert (policy.package, policy.executable) == ('socialnav', 'policy_node')
    assert given(policy)['model'] == 'auto'


def test_without_a_map_file_there_is_no_map_server(launch_file):
    nodes = launched(launch_file)
    assert 'map_server' not in nodes
    assert 'map_server' not in given(nodes['lifecycle_manager_navigation'])['node_names']
    assert given(launched(launch_file, map='a.yaml')['map_server'])['yaml_filename'] == 'a.yaml'


def test_velocities_pass_the_smoother_and_then_the_collision_monitor_and_no_other_way(launch_file):
    nodes, monitor = launched(launch_file), parameters()['collision_monitor']
    for name in ('controller_server', 'behavior_server', 'velocity_smoother'):
        assert ('cmd_vel', 'cmd_vel_nav') in nodes[name].remappings
    assert monitor['cmd_vel_in_topic'] == 'cmd_vel_smoothed'
    assert monitor['cmd_vel_out_topic'] == 'cmd_vel'
    assert 'cmd_vel' not in dict(nodes['collision_monitor'].remappings)


def test_whoever_says_or_hears_velocities_is_told_their_type(launch_file):
    nodes = launched(launch_file, enable_stamped_cmd_vel='true')
    for name in ('controller_server', 'behavior_server', 'velocity_smoother', 'collision_monitor'):
        assert given(nodes[name])['enable_stamped_cmd_vel'] is True


@pytest.mark.parametrize('topic', ['scan', 'odom', 'detections'])
def test_topics_have_the_names_of_the_robot_everywhere(launch_file, topic):
    for node in launched(launch_file, **{topic: 'other'}).values():
        if node.name != 'lifecycle_manager_navigation':
            assert (topic, 'other') in node.remappings


def test_every_argument_is_declared_with_its_default_and_counts(launch_file):
    *arguments, _ = launch_file.generate_launch_description().arguments[0]
    assert [one.arguments[0] for one in arguments] == [name for name, *_ in launch_file.ARGUMENTS]
    before = launched(launch_file)
    for name, default, *_ in launch_file.ARGUMENTS:
        other = {'true': 'false', 'false': 'true'}.get(default, 'other')
        assert launched(launch_file, **{name: other}) != before, name
