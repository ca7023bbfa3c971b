"""A simulated crowd, the policy that drives through it, and RViz where there is a display."""

import os

from ament_index_python.packages import get_package_share_directory, get_packages_with_prefixes
from launch import LaunchContext, LaunchDescription
from launch.action import Action
from launch.actions import (
    DeclareLaunchArgument,
    LogInfo,
    OpaqueFunction,
    SetEnvironmentVariable,
    Shutdown,
)
from launch_ros.actions import Node

from socialnav.demo.isolation import isolated_environment
from socialnav.parameters import DEFAULT_MODEL

ARGUMENTS = (
    ('scenario', 'hard', 'world to simulate; `socialnav scenarios` lists them', None),
    ('bounds', '7.5', 'half-width of the square that is not to be left, m; of the scenario', None),
    ('seed', '0', 'seed of the cases', None),
    (
        'model',
        DEFAULT_MODEL,
        'model: name, folder, `search`, `orca` or `straight_line`',
        None,
    ),
    ('lockstep', 'false', 'as fast as the policy decides, not in real time', ['true', 'false']),
    ('rviz', 'auto', 'show the world; auto: where there is a display', ['auto', 'true', 'false']),
)


def generate_launch_description() -> LaunchDescription:
    """Return the demo; its nodes meet only each other, on this machine."""
    arguments = [
        DeclareLaunchArgument(name, default_value=default, description=text, choices=choices)
        for name, default, text, choices in ARGUMENTS
    ]
    return LaunchDescription([*arguments, *isolation(), OpaqueFunction(function=nodes)])


def isolation() -> list[Action]:
    """Return what keeps the demo away from robots in the building."""
    environment = isolated_environment(os.environ)
    changes = {name: environment[name] for name in sorted(environment.keys() - os.environ.keys())}
    hint = f'export ROS_DOMAIN_ID={environment["ROS_DOMAIN_ID"]} to look at it from elsewhere'
    return [*(SetEnvironmentVariable(*change) for change in changes.items()), LogInfo(msg=hint)]


def nodes(context: LaunchContext) -> list[Action]:
    """Return the nodes."""
    values = context.launch_configurations
    lockstep = values['lockstep'] == 'true'
    both = {'scenario': values['scenario'], 'lockstep': lockstep}
    simulator = Node(
        package='socialnav', executable='simulator_node', output='screen', on_exit=Shutdown(),
        parameters=[{**both, 'seed': int(values['seed'])}],
    )  # fmt: skip
    policy = Node(
        package='socialnav', executable='policy_node', output='screen', on_exit=Shutdown(),
        parameters=[{**both, 'model': values['model'], 'bounds': float(values['bounds'])}],
    )  # fmt: skip
    return [simulator, policy, *(viewer() if viewer_wanted(values['rviz']) else [])]


def viewer_wanted(choice: str) -> bool:
    """
    Return whether to show the world.

    :param choice: auto, true or false.
    """
    if choice != 'auto':
        return choice == 'true'
    has_display = bool(os.environ.get('DISPLAY') or os.environ.get('WAYLAND_DISPLAY'))
    return has_display and 'rviz2' in get_packages_with_prefixes()


def viewer() -> list[Action]:
    """Return RViz, and the transform that it needs to show the map."""
    config = os.path.join(get_package_share_directory('socialnav'), 'rviz', 'socialnav.rviz')
    return [
        Node(package='rviz2', executable='rviz2', arguments=['-d', config]),
        Node(
            package='tf2_ros', executable='static_transform_publisher',
            arguments=['--frame-id', 'map', '--child-frame-id', 'odom'],
        ),
    ]  # fmt: skip
