"""The world as visualization_msgs/MarkerArray, which viewers show without other messages."""

import numpy as np

from socialnav_core.messages.parts import header, Message, rotation, vector
from socialnav_core.states import CrowdState

ARROW, CYLINDER = 0, 3
ADD, DELETE_ALL = 0, 3
HEIGHTS = {'pedestrians': 1.6, 'obstacles': 1.0, 'robot': 0.6, 'goal': 0.02, 'attention': 0.04}
COLORS = {
    'pedestrians': {'r': 0.84, 'g': 0.37, 'b': 0.0, 'a': 0.9},
    'obstacles': {'r': 0.4, 'g': 0.4, 'b': 0.4, 'a': 1.0},
    'robot': {'r': 0.0, 'g': 0.45, 'b': 0.7, 'a': 1.0},
    'goal': {'r': 0.0, 'g': 0.62, 'b': 0.45, 'a': 0.8},
    'attention': {'r': 0.8, 'g': 0.47, 'b': 0.65, 'a': 1.0},
}


def world_markers(
    state: CrowdState, goal_tolerance: float, nanoseconds: int, frame: str
) -> Message:
    """Return everything in the world, batch of one; markers shown before are replaced."""
    markers: list[Message] = []
    for index in np.flatnonzero(state.agents.valid[0]).tolist():
        name = 'obstacles' if state.agents.static[0, index] else 'pedestrians'
        place, radius = state.agents.position[0, index], float(state.agents.radius[0, index])
        markers.append(disc(name, index, place, radius))
        if not state.agents.static[0, index]:
            markers.append(arrow(name, index, place, state.agents.velocity[0, index]))
    robot = state.robot.position[0]
    markers.append(disc('goal', 0, state.robot.goal[0], goal_tolerance))
    markers.append(disc('robot', 0, robot, float(state.robot.radius[0])))
    markers.append(arrow('robot', 0, robot, state.robot.velocity[0]))
    return replacing(markers, header(nanoseconds, frame))


def replacing(markers: list[Message], header: Message) -> Message:
    """Return markers, with their header, that replace all those shown before."""
    return {'markers': [{'header': header, **one} for one in [{'action': DELETE_ALL}, *markers]]}


def disc(name: str, index: int, centre: np.ndarray, radius: float) -> Message:
    """
    Return an upright cylinder.

    :param name: namespace; it gives height and colour.
    :param index: id within the namespace.
    :param centre: m, (2,).
    """
    height = HEIGHTS[name]
    return {
        'ns': name,
        'id': index,
        'type': CYLINDER,
        'action': ADD,
        'pose': {'position': vector(centre, height / 2)},
        'scale': {'x': 2 * radius, 'y': 2 * radius, 'z': height},
        'color': COLORS[name],
    }


def arrow(name: str, index: int, foot: np.ndarray, velocity: np.ndarray) -> Message:
    """
    Return a velocity: as long as the way of one second.

    :param name: namespace of the one who moves.
    :param index: id within the namespace.
    :param foot: where the arrow begins, m, (2,).
    :param velocity: m/s, (2,).
    """
    heading = float(np.arctan2(velocity[1], velocity[0]))
    length = max(float(np.hypot(velocity[0], velocity[1])), 1e-3)
    return {
        'ns': f'{name}_velocity',
        'id': index,
        'type': ARROW,
        'action': ADD,
        'pose': {
            'position': vector(foot, HEIGHTS[name]),
            'orientation': rotation(heading),
        },
        'scale': {'x': length, 'y': 0.08, 'z': 0.08},
        'color': COLORS[name],
    }
