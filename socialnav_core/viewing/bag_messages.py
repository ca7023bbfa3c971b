"""A recorded state as the messages that the ROS 2 nodes publish of it, as plain mappings."""

import math
from typing import Any

import numpy as np

from socialnav_core.simulation.kinematics import Kinematics
from socialnav_core.simulation.kinematics.angles import rotated
from socialnav_core.states import CrowdState
from socialnav_core.viewing.recording import Recording

FRAME, BASE_FRAME = 'odom', 'base_link'
OUTCOMES = {'collision_pedestrian': 'collision', 'collision_obstacle': 'collision'}
"""Outcomes that messages call otherwise."""

Message = dict[str, Any]


def header(nanoseconds: int, frame: str = FRAME) -> Message:
    """
    Return a std_msgs/Header.

    :param nanoseconds: its time.
    :param frame: its frame.
    """
    stamp = {'sec': nanoseconds // 10**9, 'nanosec': nanoseconds % 10**9}
    return {'stamp': stamp, 'frame_id': frame}


def vector(plane: np.ndarray, z: float = 0.0) -> Message:
    """
    Return a geometry_msgs/Point or Vector3.

    :param plane: x and y, (2,).
    :param z: the third.
    """
    return {'x': float(plane[0]), 'y': float(plane[1]), 'z': z}


def rotation(heading: float) -> Message:
    """
    Return the rotation about the z axis as a geometry_msgs/Quaternion.

    :param heading: rad.
    """
    return {'x': 0.0, 'y': 0.0, 'z': math.sin(heading / 2), 'w': math.cos(heading / 2)}


def agent_states(state: CrowdState, static: bool, nanoseconds: int) -> Message:
    """
    Return pedestrians, or obstacles, as a socialnav_msgs/AgentStates.

    :param state: batch of one.
    :param static: whether obstacles are meant.
    :param nanoseconds: time of the state.
    """
    chosen = np.flatnonzero(state.agents.valid[0] & (state.agents.static[0] == static))
    agents = [
        {
            'id': index,
            'position': vector(state.agents.position[0, index]),
            'velocity': vector(state.agents.velocity[0, index]),
            'radius': float(state.agents.radius[0, index]),
        }
        for index in chosen.tolist()
    ]
    return {'header': header(nanoseconds), 'agents': agents}


def odometry(state: CrowdState, turn_rate: float, nanoseconds: int) -> Message:
    """
    Return the robot as a nav_msgs/Odometry.

    :param state: batch of one.
    :param turn_rate: of the robot, rad/s.
    :param nanoseconds: time of the state.
    """
    heading = float(state.robot.heading[0])
    pose = {'position': vector(state.robot.position[0]), 'orientation': rotation(heading)}
    linear = vector(rotated(state.robot.velocity[0], -heading))
    twist = {'linear': linear, 'angular': vector(np.zeros(2), turn_rate)}
    return {
        'header': header(nanoseconds),
        'child_frame_id': BASE_FRAME,
        'pose': {'pose': pose},
        'twist': {'twist': twist},
    }


def goal(state: CrowdState, nanoseconds: int) -> Message:
    """
    Return the robot's goal as a geometry_msgs/PoseStamped.

    :param state: batch of one.
    :param nanoseconds: time of the state.
    """
    pose = {'position': vector(state.robot.goal[0]), 'orientation': rotation(0.0)}
    return {'header': header(nanoseconds), 'pose': pose}


def command(
    chosen: np.ndarray, heading: float, kinematics: Kinematics, nanoseconds: int
) -> Message:
    """
    Return a command of the robot as a geometry_msgs/TwistStamped.

    :param chosen: (vx, vy) in the world frame or speed and turn rate, (2,).
    :param heading: of the robot, rad.
    :param nanoseconds: time of the state that it answers.
    """
    forward, left, turn_rate = kinematics.twist(kinematics.to_base(chosen, heading))
    twist = {'linear': vector(np.array([forward, left])), 'angular': {'z': turn_rate}}
    return {'header': header(nanoseconds, BASE_FRAME), 'twist': twist}


def episode_result(recording: Recording, nanoseconds: int) -> Message:
    """
    Return how an episode ended as a socialnav_msgs/EpisodeResult.

    :param recording: the episode.
    :param nanoseconds: time of its end.
    """
    steps = np.diff(recording.robot_path, axis=0)
    return {
        'header': header(nanoseconds),
        'scenario': recording.scenario,
        'seed': recording.seed,
        'case_index': recording.case_index,
        'outcome': OUTCOMES.get(recording.outcome, recording.outcome),
        'time': float(recording.times[-1]),
        'path_length': float(np.hypot(steps[:, 0], steps[:, 1]).sum()),
        'minimum_clearance': recording.minimum_clearance,
        'steps': len(recording.states) - 1,
    }
