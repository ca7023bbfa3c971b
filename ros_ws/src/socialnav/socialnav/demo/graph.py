"""Which nodes the demo starts, with which parameters and names of topics."""

import argparse

from socialnav_core.simulation import make_scenario

Parameters = dict[str, dict[str, object]]

PUBLISH_RATE = 20.0
"""States and measurements per second of simulated time, Hz."""
SENSORS = {
    'publish_scan': True, 'scan_noise': 0.02,
    'publish_detections': True, 'detection_noise': 0.05, 'missed_detections': 0.1,
}  # fmt: skip
"""What the simulated robot measures, and how badly; parameters of the simulator."""
TRUTH = {'pedestrians': 'truth/pedestrians', 'obstacles': 'truth/obstacles'}
"""Where the simulator tells what no robot is told, while the policy has to find it out."""
WALL_MARGIN = 0.1
"""Returns so near to the walls, which the policy is told, are theirs, m."""
SENSOR_TIMEOUT = 0.5
"""Age of obstacles at which a robot stops that sees them with its own scanner, s."""


def node_parameters(options: argparse.Namespace) -> Parameters:
    """Return the parameters of each node."""
    both = {'scenario': options.scenario, 'lockstep': not options.real_time}
    nodes: Parameters = {
        'simulator_node': both | {'seed': options.seed, 'episodes': options.episodes},
        'policy_node': both | {'model': options.model},
    }
    if options.real_time:
        pace_in_real_time(nodes, options)
    if options.sensors:
        add_sensors(nodes, options)
    return nodes


def pace_in_real_time(nodes: Parameters, options: argparse.Namespace) -> None:
    """
    Let the clock of the simulator be everybody's, and tell the policy the walls.

    :param nodes: parameters of each node, changed in place.
    """
    nodes['simulator_node'] |= {
        'publish_clock': True,
        'real_time_factor': options.real_time_factor,
        'publish_rate': PUBLISH_RATE * options.real_time_factor,
    }
    bounds = make_scenario(options.scenario).bounds
    nodes['policy_node'] |= {'use_sim_time': True, 'bounds': bounds}


def add_sensors(nodes: Parameters, options: argparse.Namespace) -> None:
    """
    Let the robot measure, and two nodes tell the policy what that means.

    :param nodes: parameters of each node, changed in place.
    """
    nodes['simulator_node'] |= SENSORS
    nodes['policy_node'] |= {'require_obstacles': True, 'obstacles_timeout': SENSOR_TIMEOUT}
    bounds = make_scenario(options.scenario).bounds
    nodes['obstacle_node'] = {'use_sim_time': True, 'bounds': bounds - WALL_MARGIN}
    noise = SENSORS['detection_noise']
    nodes['tracker_node'] = {'use_sim_time': True, 'detection_noise': noise}


def node_topics(options: argparse.Namespace) -> dict[str, dict[str, str]]:
    """Return other names of topics of each node."""
    return {'simulator_node': TRUTH} if options.sensors else {}
