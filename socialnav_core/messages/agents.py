"""Who walks and what stands, as socialnav_msgs/AgentStates."""

import numpy as np

from socialnav_core.messages.parts import header, Message, vector
from socialnav_core.states import CrowdState


def agent_states(state: CrowdState, static: bool, nanoseconds: int, frame: str) -> Message:
    """Return pedestrians or obstacles, batch of one; an agent's place in the state is its id."""
    agents = state.agents
    chosen = np.flatnonzero(agents.valid[0] & (agents.static[0] == static))
    return agent_states_of(
        header(nanoseconds, frame), chosen, agents.position[0, chosen],
        agents.velocity[0, chosen], agents.radius[0, chosen],
    )  # fmt: skip


def agent_states_of(
    header: Message,
    ids: np.ndarray,
    positions: np.ndarray,
    velocities: np.ndarray,
    radii: np.ndarray,
    source: str = '',
) -> Message:
    """
    Return agents that are given one by one.

    :param ids: (agents,), 32 bits.
    :param positions: m, (agents, 2).
    :param velocities: m/s, (agents, 2).
    :param radii: m, (agents,).
    :param source: who says it, where several publish on one topic.
    """
    told = zip(ids.tolist(), positions, velocities, radii.tolist(), strict=True)
    return {
        'header': header,
        'source': source,
        'agents': [
            {'id': number, 'position': vector(place), 'velocity': vector(speed), 'radius': radius}
            for number, place, speed, radius in told
        ],
    }
