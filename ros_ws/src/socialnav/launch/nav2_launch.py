"""
nav2 with the policy in the place of controller_server, and what tells the policy of the world.

What tells where the robot is in the map (amcl, slam_toolbox) must run besides. This file has not
been run: there was no nav2 where it was written. Tests hold it to what is there and documented.
"""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchContext, LaunchDescription
from launch.action import Action
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch_ros.actions import Node

SWITCH = ['true', 'false']
ARGUMENTS = (
    ('params_file', '', 'parameters of all nodes; empty: nav2_params.yaml of this package', None),
    ('map', '', 'YAML file for map_server; empty: somebody else publishes the map', None),
    ('model', 'auto', 'of the policy: name, path, or a policy without network', None),
    ('autostart', 'true', 'whether the manager activates all nodes at once', SWITCH),
    ('enable_stamped_cmd_vel', 'false', 'TwistStamped, where the base wants that', SWITCH),
    ('use_sim_time', 'false', 'take the time from /clock', SWITCH),
    ('scan', 'scan', 'topic of the laser', None),
    ('odom', 'odom', 'topic of odometry', None),
    ('detections', 'detections', 'topic of detected people', None),
)
SERVERS = {
    'map_server': 'nav2_map_server',
    'planner_server': 'nav2_planner',
    'behavior_server': 'nav2_behaviors',
    'bt_navigator': 'nav2_bt_navigator',
    'velocity_smoother': 'nav2_velocity_smoother',
    'collision_monitor': 'nav2_collision_monitor',
}
"""nav2's own nodes, each named as its executable, and their packages, in order of activation."""
CONTROLLER = 'controller_server'
"""The name that policy_node has here."""
UNSMOOTHED = 'cmd_vel_nav'
"""What velocity_smoother hears; collision_monitor hears what it says, and alone says cmd_vel."""


def generate_launch_description() -> LaunchDescription:
    """Return everything but localization."""
    arguments = [
        DeclareLaunchArgument(name, default_value=default, description=text, choices=choices)
        for name, default, text, choices in ARGUMENTS
    ]
    return LaunchDescription([*arguments, OpaqueFunction(function=nodes)])


def nodes(context: LaunchContext) -> list[Action]:
    """Return the nodes."""
    values = dict(context.launch_configurations)
    share = get_package_share_directory('socialnav')
    file = values['params_file'] or os.path.join(share, 'config', 'nav2_params.yaml')
    wanted = [name for name in SERVERS if name != 'map_server' or values['map']]
    servers = [server(name, file, values) for name in wanted]
    return [*servers, *own_nodes(file, values), manager(wanted, file, values)]


def server(name: str, file: str, values: dict[str, str]) -> Node:
    """Return a node of nav2."""
    own = {'yaml_filename': values['map']} if name == 'map_server' else stamped(values)
    velocity = [('cmd_vel', UNSMOOTHED)] * (name in ('behavior_server', 'velocity_smoother'))
    return Node(
        package=SERVERS[name], executable=name, name=name, output='screen',
        parameters=[file, {'use_sim_time': is_true(values['use_sim_time'])}, own],
        remappings=[*topics(values), *velocity],
    )  # fmt: skip


def own_nodes(file: str, values: dict[str, str]) -> list[Node]:
    """Return the policy in the place of nav2's controller, and what tells it of the world."""
    time = is_true(values['use_sim_time'])
    policy = Node(
        package='socialnav', executable='policy_node', name=CONTROLLER, output='screen',
        parameters=[file, {'use_sim_time': time, 'model': values['model']}, stamped(values)],
        remappings=[*topics(values), ('cmd_vel', UNSMOOTHED)],
    )  # fmt: skip
    obstacles = Node(
        package='socialnav', executable='obstacle_node', name='obstacle_node', output='screen',
        parameters=[file, {'use_sim_time': time}], remappings=topics(values),
    )  # fmt: skip
    people = Node(
        package='socialnav', executable='tracker_node', name='tracker_node', output='screen',
        parameters=[file, {'use_sim_time': time}], remappings=topics(values),
    )  # fmt: skip
    return [policy, obstacles, people]


def manager(servers: list[str], file: str, values: dict[str, str]) -> Node:
    """Return the manager, which activates those who are called before those who call."""
    order = [*servers]
    order.insert(order.index('behavior_server'), CONTROLLER)
    own = {
        'use_sim_time': is_true(values['use_sim_time']),
        'autostart': is_true(values['autostart']),
        'node_names': order,
    }
    return Node(
        package='nav2_lifecycle_manager', executable='lifecycle_manager', output='screen',
        name='lifecycle_manager_navigation', parameters=[file, own],
    )  # fmt: skip


def topics(values: dict[str, str]) -> list[tuple[str, str]]:
    """Return the names that topics have on this robot."""
    return [(topic, values[topic]) for topic in ('scan', 'odom', 'detections')]


def stamped(values: dict[str, str]) -> dict[str, bool]:
    """Return the parameter of those who say or hear velocities."""
    return {'enable_stamped_cmd_vel': is_true(values['enable_stamped_cmd_vel'])}


def is_true(text: str) -> bool:
    """Return the value of a switch."""
    return text == 'true'
