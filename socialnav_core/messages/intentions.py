"""What the policy looks at and what it is about to do, for eyes."""

import numpy as np

from socialnav_core.messages.markers import disc, replacing
from socialnav_core.messages.parts import header, Message, rotation, vector
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.states import CrowdState

PATH_TIMES = np.arange(0.0, 1.01, 0.1)
"""Times of the poses of a predicted path, s."""


def predicted_path(
    state: CrowdState, command: np.ndarray, kinematics: str, nanoseconds: int, frame: str
) -> Message:
    """
    Return where the robot goes when it keeps to its command, as a nav_msgs/Path.

    :param state: when the command takes effect, batch of one.
    :param command: (vx, vy) in the world frame or speed and turn rate, (2,).
    :param kinematics: holonomic or differential.
    """
    told, poses, move = header(nanoseconds, frame), [], kinematics_of(kinematics).move
    for time in PATH_TIMES:
        displacement, _, heading = move(state.robot.heading[0], command, time)
        poses.append(pose_of(told, state.robot.position[0] + displacement, float(heading)))
    return {'header': told, 'poses': poses}


def planned_path(state: CrowdState, plan: np.ndarray, nanoseconds: int, frame: str) -> Message:
    """
    Return where the robot goes when it keeps to its plan, as a nav_msgs/Path.

    Each pose looks along the way there.

    :param state: when the plan begins, batch of one.
    :param plan: positions, m, (steps, 2).
    """
    told, places = header(nanoseconds, frame), np.concatenate([state.robot.position, plan])
    ways = np.diff(places, axis=0)
    headings = [state.robot.heading[0], *np.arctan2(ways[:, 1], ways[:, 0])]
    poses = [pose_of(told, *pair) for pair in zip(places, headings, strict=True)]
    return {'header': told, 'poses': poses}


def pose_of(told: Message, place: np.ndarray, heading: float) -> Message:
    """Return a geometry_msgs/PoseStamped on the ground."""
    pose = {'position': vector(place), 'orientation': rotation(float(heading))}
    return {'header': told, 'pose': pose}


def attention_markers(
    state: CrowdState, weights: np.ndarray, nanoseconds: int, frame: str
) -> Message:
    """
    Return a disc around each agent, the denser the more the network looks at it.

    They are a visualization_msgs/MarkerArray and replace all those shown before.

    :param state: batch of one.
    :param weights: that sum to 1, (agents,).
    """
    markers = []
    for index in np.flatnonzero(state.agents.valid[0]).tolist():
        radius = 1.5 * float(state.agents.radius[0, index])
        marker = disc('attention', index, state.agents.position[0, index], radius)
        marker['color'] = marker['color'] | {'a': float(weights[index])}
        markers.append(marker)
    return replacing(markers, header(nanoseconds, frame))
