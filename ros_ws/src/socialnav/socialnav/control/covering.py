"""Agents where only the robot itself can be."""

import numpy as np

from socialnav_core.states import CrowdState


def covering_complaint(state: CrowdState) -> str | None:
    """
    Return who stands in the robot's own place, or None.

    Among such agents no command is right, and every policy would stand without a word.

    :param state: batch of one.
    """
    agents, radius = state.agents, float(state.robot.radius[0])
    distance = np.linalg.norm(agents.position[0] - state.robot.position[0], axis=-1)
    gap = distance - agents.radius[0]
    person = (
        agents.valid[0] & ~agents.static[0] & (distance < np.maximum(agents.radius[0], radius))
    )
    if person.any():
        return (
            f'a pedestrian where the robot is ({distance[person].min():.2f} m from its centre): '
            'does the tracker take the robot for a person?'
        )
    thing = agents.valid[0] & agents.static[0] & (gap < radius / 2)
    if thing.any():
        return (
            f'an obstacle within the robot ({gap[thing].min():.2f} m from its centre): '
            'parts of its own? obstacle_node leaves out what is nearer than footprint_radius'
        )
    return None
