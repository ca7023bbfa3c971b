"""What the kernels of the search read of a state: the only place that knows its fields."""

from typing import NamedTuple

import numpy as np

from socialnav_core.states import CrowdState


class Worlds(NamedTuple):
    """The arrays of a batch of worlds, contiguous, SI units."""

    position: np.ndarray  # of the robots, (batch, 2)
    velocity: np.ndarray  # (batch, 2)
    goal: np.ndarray  # (batch, 2)
    radius: np.ndarray  # (batch,)
    speed: np.ndarray  # preferred, (batch,)
    bounds: np.ndarray  # half-width of the walls, inf for none, (batch,)
    agents: np.ndarray  # centres, (batch, agents, 2)
    radii: np.ndarray  # of the agents, (batch, agents)
    people: np.ndarray  # whether an agent is a person, bool, (batch, agents)
    obstacles: np.ndarray  # whether an agent is an obstacle, bool, (batch, agents)


def worlds_of(state: CrowdState) -> Worlds:
    """Return what the kernels read of a state."""
    robot, agents = state.robot, state.agents
    numbers = (
        robot.position, robot.velocity, robot.goal, robot.radius, robot.preferred_speed,
        state.bounds, agents.position, agents.radius,
    )  # fmt: skip
    masks = agents.valid & ~agents.static, agents.valid & agents.static
    arrays = (*(np.asarray(array, dtype=np.float64) for array in numbers), *masks)
    return Worlds(*(np.ascontiguousarray(array) for array in arrays))
