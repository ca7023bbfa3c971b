"""Layers and cells of the search for a differential drive, and the memory that it works in."""

from typing import NamedTuple

import numpy as np

from socialnav_core.config import SearchConfig
from socialnav_core.policies.search.lattice import make_surroundings

TURNS, SPEEDS = 7, 5
"""At most so many turn rates and speeds are tried from a node."""
KEPT = 16
"""A layer keeps at most so many nodes for each that is followed; what comes later falls away."""
RISK_LAYER = 0.25
"""Risks are those of the holonomic search, which counts and discounts them by such layers, s."""


class Lattice(NamedTuple):
    """The discrete part of the search."""

    durations: np.ndarray  # of the layers, s, (layers,)
    lags: np.ndarray  # share of a change of command that counts in its layer, (layers,)
    cells: np.ndarray  # sides of the cells of each layer, s at preferred speed, (layers,)
    contact: np.ndarray  # cost of a certain contact in each layer, s, (layers,)
    intrusion: np.ndarray  # cost of certain discomfort in each layer, s, (layers,)
    surprise: np.ndarray  # cost of somebody who cannot be evaded in each layer, s, (layers,)
    fine_layers: int  # layers in which half changes are tried too
    beam: int  # nodes of a layer that are followed
    slack: float  # s
    headings: int
    speeds: int
    turn_rates: int
    steering: float  # s
    turn_loss: float
    arc_share: float


class Workspace(NamedTuple):
    """
    Memory of the search, for one world at a time.

    What has to do with people and obstacles is as in the workspace of the holonomic search, so
    that both share the kernels that fill and read it.
    """

    nodes: np.ndarray  # (layers + 1, nodes, columns: X to TOTAL)
    parent: np.ndarray  # node of the layer before, (layers + 1, nodes)
    cells: np.ndarray  # numbers of the cells in the table, (places,)
    occupant: np.ndarray  # their nodes in the layer that is filled, -1 for none, (places,)
    turns: np.ndarray  # turn rates that are tried from a node, rad/s, (TURNS,)
    speeds: np.ndarray  # speeds that are tried from a node, m/s, (SPEEDS,)
    track: np.ndarray  # where people will be, m, (layers + 1, people, 2)
    spread: np.ndarray  # (layers, people, columns: INVERSE_DEVIATION, REACH)
    body: np.ndarray  # (people, columns: CONTACT_DISTANCE, WEIGHT)
    order: np.ndarray  # people by distance, as agent + agents * mode, (people,)
    gaps: np.ndarray  # their distances, m, (people,)
    active: np.ndarray  # who can matter in a layer, (people,)
    near: np.ndarray  # who can matter for a node, (people, columns: FROM_X to SHARE)
    discs: np.ndarray  # obstacles within the horizon: x, y, distance to keep, m, (agents, 3)
    near_discs: np.ndarray  # those within one step of a node, with offsets from it, (agents, 3)


X, Y, HEADING, SPEED, TURN_RATE, SPENT, TOTAL = range(7)
"""Columns of nodes: m, m, rad, m/s, rad/s; cost so far and in all, s."""


def make_lattice(settings: SearchConfig, period: float) -> Lattice:
    """
    Return the lattice that settings ask for.

    :param period: time until the next command, s: the duration of the first layer.
    """
    own = settings.differential
    durations = layer_durations(settings, period)
    starts = np.cumsum(durations) - durations
    ages, shares = np.maximum(starts - own.sure, 0.0) / RISK_LAYER, durations / RISK_LAYER
    contact = settings.contact * settings.contact_discount**ages * shares
    return Lattice(
        durations=durations,
        lags=np.minimum(1.0, 0.5 * (1.0 + period / durations)),
        cells=np.where(starts < own.near - 1e-9, own.cell, own.far_cell),
        contact=contact,
        intrusion=settings.intrusion * settings.intrusion_discount**ages * durations,
        surprise=np.where(starts < own.near - 1e-9, contact * (own.surprises * RISK_LAYER), 0.0),
        fine_layers=own.fine_layers,
        beam=own.beam,
        slack=own.slack,
        headings=own.headings,
        speeds=own.speeds,
        turn_rates=own.turn_rates,
        steering=own.steering,
        turn_loss=own.turn_loss,
        arc_share=own.arc_share,
    )


def layer_durations(settings: SearchConfig, period: float) -> np.ndarray:
    """Return how long layers last, s: a period, then short ones, then long ones."""
    durations, time = [period], period
    while time < settings.horizon - 1e-9:
        near = time < settings.differential.near - 1e-9
        duration = settings.layer if near else settings.differential.far_layer
        durations.append(max(duration, period))
        time += durations[-1]
    return np.array(durations)


def make_workspace(lattice: Lattice, agents: int, modes: int) -> Workspace:
    """Return memory for worlds of a number of agents, predicted in a number of modes."""
    layers = len(lattice.durations)
    nodes = (layers + 1, KEPT * lattice.beam + TURNS * SPEEDS + 1)
    places = 1 << (2 * nodes[1]).bit_length()  # half of the table stays empty
    return Workspace(
        nodes=np.zeros((*nodes, TOTAL + 1)),
        parent=np.zeros(nodes, np.int64),
        cells=np.zeros(places, np.int64),
        occupant=np.full(places, -1),
        turns=np.zeros(TURNS),
        speeds=np.zeros(SPEEDS),
        **make_surroundings(layers, agents, modes),
    )
