"""What the policy looks at and what it is about to do, for eyes."""

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
import numpy as np
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from socialnav.messages.conversions import quaternion_of
from socialnav.messages.markers import disc, point
from socialnav.messages.stamps import header_message
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.states import CrowdState

PATH_TIMES = np.arange(0.0, 1.01, 0.1)
"""Times of the poses of a predicted path, s."""


def predicted_path(
    state: CrowdState, command: np.ndarray, kinematics: str, nanoseconds: int, frame: str
) -> Path:
    """
    Return where the robot goes when it keeps to its command.

    :param state: when the command takes effect, batch of one.
    :param command: (vx, vy) in the world frame or speed and turn rate, (2,).
    :param kinematics: holonomic or differential.
    :param nanoseconds: time of the message.
    :param frame: frame of the state.
    """
    header = header_message(nanoseconds, frame)
    path, move = Path(header=header), kinematics_of(kinematics).move
    for time in PATH_TIMES:
        displacement, _, heading = move(state.robot.heading[0], command, time)
        pose = PoseStamped(header=header)
        pose.pose.position = point(state.robot.position[0] + displacement, 0.0)
        pose.pose.orientation = quaternion_of(float(heading))
        path.poses.append(pose)
    return path


def planned_path(state: CrowdState, plan: np.ndarray, nanoseconds: int, frame: str) -> Path:
    """
    Return where the robot goes when it keeps to its plan, each pose looking along the way there.

    :param state: when the plan begins, batch of one.
    :param plan: positions, m, (steps, 2).
    :param nanoseconds: time of the message.
    :param frame: frame of state and plan.
    """
    header = header_message(nanoseconds, frame)
    places = np.concatenate([state.robot.position, plan])
    ways = np.diff(places, axis=0)
    headings = [state.robot.heading[0], *np.arctan2(ways[:, 1], ways[:, 0])]
    path = Path(header=header)
    for place, heading in zip(places, headings, strict=True):
        pose = PoseStamped(header=header)
        pose.pose.position = point(place, 0.0)
        pose.pose.orientation = quaternion_of(float(heading))
        path.poses.append(pose)
    return path


def attention_markers(
    state: CrowdState, weights: np.ndarray, nanoseconds: int, frame: str
) -> MarkerArray:
    """
    Return a disc around each agent, the denser the more the network looks at it.

    :param state: batch of one.
    :param weights: that sum to 1, (agents,).
    :param nanoseconds: time of the message.
    :param frame: frame of the state.
    """
    header = header_message(nanoseconds, frame)
    markers = [Marker(header=header, action=Marker.DELETEALL)]
    for index in np.flatnonzero(state.agents.valid[0]).tolist():
        radius = 1.5 * float(state.agents.radius[0, index])
        marker = disc(header, 'attention', index, state.agents.position[0, index], radius)
        color = marker.color  # shared by all discs of this kind
        marker.color = ColorRGBA(r=color.r, g=color.g, b=color.b, a=float(weights[index]))
        markers.append(marker)
    return MarkerArray(markers=markers)
