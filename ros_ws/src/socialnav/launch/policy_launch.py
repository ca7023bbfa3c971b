"""The policy alone, on a robot; every topic can be given the name that the robot uses."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

TOPICS = {
    'cmd_vel': 'velocity to drive with',
    'odom': 'odometry of the robot',
    'pedestrians': 'who walks near by',
    'obstacles': 'what stands near by',
    'goal_pose': 'where to go',
    'plan': 'way to go there, from a planner',
    'map': 'walls, with the parameter use_map',
}
"""Topics of the node, by the name that it knows them by; each is an argument."""


def generate_launch_description() -> LaunchDescription:
    """Return the node with its arguments."""
    share = get_package_share_directory('socialnav')
    parameters = os.path.join(share, 'config', 'policy.yaml')
    arguments = {
        'model': ('search', 'name in the share folder, path, `search`, `orca` or `straight_line`'),
        'params_file': (parameters, 'other parameters; copy the default one and change it'),
        'use_sim_time': ('false', 'take the time from /clock'),
        **{name: (name, f'topic: {text}') for name, text in TOPICS.items()},
    }
    node = Node(
        package='socialnav',
        executable='policy_node',
        output='screen',
        parameters=[
            LaunchConfiguration('params_file'),
            {
                'model': ParameterValue(LaunchConfiguration('model'), value_type=str),
                'use_sim_time': ParameterValue(
                    LaunchConfiguration('use_sim_time'), value_type=bool
                ),
            },
        ],
        remappings=[(name, LaunchConfiguration(name)) for name in TOPICS],
    )
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text)
        for name, (default, text) in arguments.items()
    ]
    return LaunchDescription([*declared, node])
