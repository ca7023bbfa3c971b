"""The world for eyes: discs, arrows and the goal."""

from geometry_msgs.msg import Point
import numpy as np
from std_msgs.msg import ColorRGBA, Header
from visualization_msgs.msg import Marker, MarkerArray

from socialnav.messages.conversions import quaternion_of
from socialnav.messages.stamps import header_message
from socialnav_core.states import CrowdState

HEIGHTS = {'pedestrians': 1.6, 'obstacles': 1.0, 'robot': 0.6, 'goal': 0.02, 'attention': 0.04}
COLORS = {
    'pedestrians': ColorRGBA(r=0.84, g=0.37, b=0.0, a=0.9),
    'obstacles': ColorRGBA(r=0.4, g=0.4, b=0.4, a=1.0),
    'robot': ColorRGBA(r=0.0, g=0.45, b=0.7, a=1.0),
    'goal': ColorRGBA(r=0.0, g=0.62, b=0.45, a=0.8),
    'attention': ColorRGBA(r=0.8, g=0.47, b=0.65, a=1.0),
}


def world_markers(
    state: CrowdState, goal_tolerance: float, nanoseconds: int, frame: str
) -> MarkerArray:
    """
    Return everything in the world; markers shown before are replaced.

    :param state: the world; its first one is shown.
    :param goal_tolerance: radius of the goal, m.
    :param nanoseconds: time of the state.
    :param frame: frame of the state.
    """
    header = header_message(nanoseconds, frame)
    markers = [Marker(header=header, action=Marker.DELETEALL)]
    for index in np.flatnonzero(state.agents.valid[0]).tolist():
        name = 'obstacles' if state.agents.static[0, index] else 'pedestrians'
        centre, radius = state.agents.position[0, index], float(state.agents.radius[0, index])
        markers.append(disc(header, name, index, centre, radius))
        if not state.agents.static[0, index]:
            markers.append(arrow(header, name, index, centre, state.agents.velocity[0, index]))
    robot, goal = state.robot.position[0], state.robot.goal[0]
    markers.append(disc(header, 'goal', 0, goal, goal_tolerance))
    markers.append(disc(header, 'robot', 0, robot, float(state.robot.radius[0])))
    markers.append(arrow(header, 'robot', 0, robot, state.robot.velocity[0]))
    return MarkerArray(markers=markers)


def disc(header: Header, name: str, index: int, centre: np.ndarray, radius: float) -> Marker:
    """
    Return an upright cylinder.

    :param header: of the marker.
    :param name: namespace; it gives height and colour.
    :param index: id within the namespace.
    :param centre: m, (2,).
    :param radius: m.
    """
    height = HEIGHTS[name]
    marker = Marker(header=header, ns=name, id=index, type=Marker.CYLINDER, action=Marker.ADD)
    marker.pose.position = point(centre, height / 2)
    marker.pose.orientation.w = 1.0
    marker.scale.x = marker.scale.y = 2 * radius
    marker.scale.z = height
    marker.color = COLORS[name]
    return marker


def arrow(header: Header, name: str, index: int, foot: np.ndarray, velocity: np.ndarray) -> Marker:
    """
    Return a velocity: as long as the way of one second.

    :param header: of the marker.
    :param name: namespace of the one who moves.
    :param index: id within the namespace.
    :param foot: where the arrow begins, m, (2,).
    :param velocity: m/s, (2,).
    """
    marker = Marker(header=header, ns=f'{name}_velocity', id=index, type=Marker.ARROW)
    marker.pose.position = point(foot, HEIGHTS[name])
    marker.pose.orientation = quaternion_of(float(np.arctan2(velocity[1], velocity[0])))
    marker.scale.x = max(float(np.hypot(velocity[0], velocity[1])), 1e-3)
    marker.scale.y = marker.scale.z = 0.08
    marker.color = COLORS[name]
    return marker


def point(place: np.ndarray, height: float) -> Point:
    """
    Return a point in space.

    :param place: m, (2,).
    :param height: m.
    """
    return Point(x=float(place[0]), y=float(place[1]), z=height)
