"""What the policy looks at and what it is about to do, for eyes."""

import numpy as np

from socialnav_core.messages.markers import disc, replacing
from socialnav_core.messages.parts import header, Message, rotation, vector
from socialnav_core.simulation.kinematics import move_robot
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
    told, poses = header(nanoseconds, frame), []
    for time in PATH_TIMES:
        displacement, _, heading = move_robot(kinematics, state.robot.heading[0], command, time)
        place = vector(state.robot.position[0] + displacement)
        pose = {'position': place, 'orientation': rotation(float(heading))}
        poses.append({'header': told, 'pose': pose})
    return {'header': told, 'poses': poses}


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
