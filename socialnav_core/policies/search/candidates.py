"""The best ways on by their first motion, between which more than the search may choose."""

from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.fields import frame_of, way_down
from socialnav_core.policies.search.lattice import X, Y

TOTAL = -1
"""The last column of nodes, in the search for either kind of robot."""


class Candidates(NamedTuple):
    """
    Paths to the last layer, at most one for each first motion.

    A world whose robot arrives within the horizon has none: nothing is to be weighed there.
    """

    totals: np.ndarray  # expected costs, s, inf where there is none, (batch, candidates)
    plans: np.ndarray  # positions at the end of each layer, m, (batch, candidates, layers, 2)
    firsts: np.ndarray  # node of layer 1 of each, scratch, (candidates,)
    lasts: np.ndarray  # node of the last layer of each, scratch, (candidates,)


def make_candidates(batch: int, count: int, layers: int) -> Candidates:
    """Return memory for a number of candidates in each world; there are none yet."""
    return Candidates(
        np.full((batch, count), np.inf), np.zeros((batch, count, layers, 2)),
        np.zeros(count, np.int64), np.zeros(count, np.int64),
    )  # fmt: skip


@inlined
def write_candidates(world, count, best, slack, space, candidates):  # type: ignore[no-untyped-def]
    """
    Write the cheapest node of the last layer for each first motion.

    Where there are more than there is room for, the cheapest are kept.

    :param count: number of nodes in the last layer.
    :param best: least total among them, s.
    :param slack: what is worse than the best by more than this is none, s.
    """
    last, room, filled = space.nodes.shape[0] - 1, candidates.firsts.size, 0
    totals = candidates.totals[world]
    for node in range(count):
        total = space.nodes[last, node, TOTAL]
        if room == 0 or total > best + slack:
            continue
        first = node
        for layer in range(last, 1, -1):
            first = space.parent[layer, first]
        place = 0
        while place < filled and candidates.firsts[place] != first:
            place += 1
        if place == room:
            place = np.argmax(totals)
        if place == filled:
            filled += 1
        elif totals[place] <= total:
            continue
        totals[place], candidates.firsts[place], candidates.lasts[place] = total, first, node
    for place in range(filled):
        node = candidates.lasts[place]
        for layer in range(last, 0, -1):
            candidates.plans[world, place, layer - 1, 0] = space.nodes[layer, node, X]
            candidates.plans[world, place, layer - 1, 1] = space.nodes[layer, node, Y]
            node = space.parent[layer, node]


@compiled
def ways_on(worlds, slots, fields, positions, distances, subgoals):  # type: ignore[no-untyped-def]
    """
    Write how far the goal is from some positions around the obstacles, and a goal in sight.

    :param positions: m, (batch, positions, 2).
    :param distances: m, (batch, positions).
    :param subgoals: the point at that distance straight down the slope, m, (batch, positions, 2).
    """
    for world in range(positions.shape[0]):
        field, frame = fields.distance[max(0, slots[world])], frame_of(fields, slots[world])
        for i in range(positions.shape[1]):
            x, y = positions[world, i, 0], positions[world, i, 1]
            down_x, down_y, distance = way_down(
                field, frame, x, y, worlds.goal[world, 0], worlds.goal[world, 1]
            )
            distances[world, i] = distance
            subgoals[world, i, 0] = x + down_x * distance
            subgoals[world, i, 1] = y + down_y * distance
