"""The data that every part shares: the world as it is, and what a network sees of it."""

import dataclasses

import numpy as np


@dataclasses.dataclass
class CrowdState:
    """
    A batch of worlds: one robot each, and the agents around it.

    Arrays are NumPy float64 (masks bool), world frame, SI units, batch axis first. Pedestrians and
    static obstacles are both agents. An agent whose ``valid`` is False is padding: nothing may
    depend on its other fields.
    """

    robot_position: np.ndarray
    """Robot centre, m, (batch, 2)."""
    robot_velocity: np.ndarray
    """Robot velocity, m/s, (batch, 2)."""
    robot_heading: np.ndarray
    """Robot heading, rad, counter-clockwise from the x axis, (batch,)."""
    robot_radius: np.ndarray
    """Robot radius, m, (batch,)."""
    robot_preferred_speed: np.ndarray
    """Speed the robot would like to drive at, m/s, (batch,)."""
    robot_goal: np.ndarray
    """Where the robot should arrive, m, (batch, 2)."""
    position: np.ndarray
    """Agent centres, m, (batch, agents, 2)."""
    velocity: np.ndarray
    """Agent velocities, m/s, (batch, agents, 2)."""
    radius: np.ndarray
    """Agent radii, m, (batch, agents)."""
    static: np.ndarray
    """Whether an agent is an obstacle that never moves, bool, (batch, agents)."""
    valid: np.ndarray
    """Whether an agent is real, bool, (batch, agents)."""
    bounds: np.ndarray
    """Half-width of the square around the origin not to be left, m, inf for none, (batch,)."""
    time: np.ndarray
    """Time since the start of the episode, s, (batch,)."""

    @property
    def batch_size(self) -> int:
        """Return the number of worlds."""
        return self.position.shape[0]

    @property
    def agents(self) -> int:
        """Return the number of agent slots of a world, padding included."""
        return self.position.shape[1]

    def copy(self) -> 'CrowdState':
        """Return a state that shares no memory with this one."""
        return CrowdState(*[getattr(self, name).copy() for name in CROWD_STATE_FIELDS])

    def select(self, worlds: np.ndarray) -> 'CrowdState':
        """
        Return the state of some worlds.

        :param worlds: indices or a mask along the batch axis.
        """
        return self.map(lambda array: array[worlds])

    def map(self, function) -> 'CrowdState':  # type: ignore[no-untyped-def]
        """
        Return a state with a function applied to each array.

        :param function: takes and returns an array.
        """
        return CrowdState(*(function(getattr(self, name)) for name in CROWD_STATE_FIELDS))


CROWD_STATE_FIELDS = tuple(field.name for field in dataclasses.fields(CrowdState))


@dataclasses.dataclass
class Observation:
    """What a value network sees: the world turned so that the goal lies on the x axis, float32."""

    robot: np.ndarray
    """[goal distance, preferred speed, heading, radius, vx, vy], (..., 6)."""
    others: np.ndarray
    """[px, py, vx, vy, radius, distance, sum of radii] of each agent, (..., agents, 7)."""
    mask: np.ndarray
    """Whether an agent is real, bool, (..., agents)."""
