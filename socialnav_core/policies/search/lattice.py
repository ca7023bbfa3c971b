"""Actions, layers and cells of the search, and the memory that it works in."""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.config import SearchConfig
from socialnav_core.simulation.kinematics.angles import direction


class Lattice(NamedTuple):
    """The discrete part of the search; lengths are in seconds at preferred speed."""

    actions: np.ndarray  # velocities over preferred speed, the stop first, (actions, 2)
    durations: np.ndarray  # of the layers, s, (layers,)
    cells: np.ndarray  # sides of the cells of each layer, (layers,)
    width: int  # cells along a side that any layer can need, odd


class Workspace(NamedTuple):
    """
    Memory of the search, for one world at a time.

    Few arrays with named columns rather than many: numba counts references to each array that it
    hands on. The robot is node 0 of layer 0; the last node of each layer is the arrival.
    """

    nodes: np.ndarray  # (layers + 1, nodes, columns: X to TOTAL)
    parent: np.ndarray  # node of the layer before, (layers + 1, nodes)
    occupant: np.ndarray  # node of each cell of the layer that is filled, -1 for none, (cells,)
    moves: np.ndarray  # velocities of the lattice for this world, m/s, (actions, 2)
    track: np.ndarray  # where people will be, m, (layers + 1, people, 2)
    spread: np.ndarray  # (layers, people, columns: INVERSE_DEVIATION, REACH)
    body: np.ndarray  # (people, columns: CONTACT_DISTANCE, WEIGHT)
    order: np.ndarray  # people by distance, as agent + agents * mode, (people,)
    gaps: np.ndarray  # their distances, m, (people,)
    active: np.ndarray  # who can matter in a layer, (people,)
    near: np.ndarray  # who can matter for a node, (people, columns: FROM_X to SHARE)
    discs: np.ndarray  # obstacles within the horizon: x, y, distance to keep, m, (agents, 3)
    near_discs: np.ndarray  # those within one step of a node, with offsets from it, (agents, 3)


X, Y, VELOCITY_X, VELOCITY_Y, SPENT, TOTAL = range(6)
"""Columns of nodes: position, m; velocity that led there, m/s; cost so far and in all, s."""
INVERSE_DEVIATION, REACH = range(2)
"""Columns of spread: 1/m; gap from which on somebody costs nothing, m."""
CONTACT_DISTANCE, WEIGHT = range(2)
"""Columns of body: sum of radii, m; probability of the mode."""
FROM_X, FROM_Y, WALK_X, WALK_Y, CONTACT, INVERSE, GAP, SHARE = range(8)
"""Columns of near: offset and displacement, m, and the above."""


def make_lattice(settings: SearchConfig) -> Lattice:
    """Return the lattice that settings ask for."""
    later = max(settings.layer, settings.time_step)
    layers = 1 + max(0, round((settings.horizon - settings.time_step) / later))
    durations = np.full(layers, later)
    durations[0] = settings.time_step
    cells = np.full(layers, settings.cell)
    cells[: settings.fine_layers] = settings.fine_cell
    angles = np.arange(settings.headings) * (2.0 * math.pi / settings.headings)
    speeds = np.arange(settings.speeds, 0, -1) / settings.speeds
    moves = (speeds[:, None, None] * direction(angles)).reshape(-1, 2)
    reach = int(np.ceil(np.cumsum(durations) / cells).max()) + 1
    return Lattice(np.concatenate([np.zeros((1, 2)), moves]), durations, cells, 2 * reach + 1)


def make_workspace(lattice: Lattice, agents: int, modes: int) -> Workspace:
    """Return memory for worlds of a number of agents, predicted in a number of modes."""
    layers = len(lattice.durations)
    nodes = (layers + 1, lattice.width**2 + 1)
    return Workspace(
        nodes=np.zeros((*nodes, TOTAL + 1)),
        parent=np.zeros(nodes, np.int64),
        occupant=np.zeros(lattice.width**2, np.int64),
        moves=np.zeros_like(lattice.actions),
        **make_surroundings(layers, agents, modes),
    )


def make_surroundings(layers: int, agents: int, modes: int) -> dict[str, np.ndarray]:
    """Return the part of a workspace, by name, that has to do with people and obstacles."""
    people, discs = max(1, agents * modes), max(1, agents)
    return {
        'track': np.zeros((layers + 1, people, 2)),
        'spread': np.zeros((layers, people, REACH + 1)),
        'body': np.zeros((people, WEIGHT + 1)),
        'order': np.zeros(people, np.int64),
        'gaps': np.zeros(people),
        'active': np.zeros(people, np.int64),
        'near': np.zeros((people, SHARE + 1)),
        'discs': np.zeros((discs, 3)),
        'near_discs': np.zeros((discs, 3)),
    }
