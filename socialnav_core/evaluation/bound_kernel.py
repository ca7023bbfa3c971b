"""
Clairvoyant search: the fastest way through people whose every step is known.

A* over exact positions, a layer a step of time. Of the positions of a layer that fall into one
cell the one that is found first is kept. What remains is the straight line, which no robot beats.
"""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled, inlined
from socialnav_core.simulation.rewards import swept_distance

UNSOLVED, NO_ROOM = -1, -2
TOUCH = 1e-6
"""Gap that is kept besides, m, so that the path also holds where sums are rounded otherwise."""
FINENESS = 16
"""Positions are taken up in the order of their estimates, to this part of a step."""
SPREAD = np.uint64(0x9E3779B97F4A7C15)  # 2^64 over the golden ratio spreads keys over a table


class Trip(NamedTuple):
    """What one case asks of the robot."""

    start_x: float
    start_y: float
    goal_x: float
    goal_y: float
    tolerance: float
    """Distance from the goal that counts as arrived, m."""
    stride: float
    """Way of a step at preferred speed, m."""
    limit: float
    """Largest coordinate of the centre within the walls, m."""
    duration: float
    """Of a step, s."""
    cell: float
    """Side of a cell, m."""


class Nodes(NamedTuple):
    """Positions that can be reached, and the order in which they are taken up."""

    place: np.ndarray
    """m, (room, 2)."""
    layer: np.ndarray
    """Steps made, (room,)."""
    parent: np.ndarray
    """Node before, (room,)."""
    following: np.ndarray
    """Next node of the same estimate, -1 for none, (room,)."""
    first: np.ndarray
    """First node of each estimate, -1 for none, (estimates,)."""
    table: np.ndarray
    """Keys of the cells that are taken, -1 where free; a power of two, (twice the room,)."""


@compiled
def fastest_path(trip, position, velocity, keep, moves, room, path):  # type: ignore[no-untyped-def]
    """
    Return the number of steps of the fastest path, UNSOLVED or NO_ROOM.

    :param trip: Trip.
    :param position: of the agents before each step, m, (steps, agents, 2).
    :param velocity: in each step, m/s, (steps, agents, 2).
    :param keep: distance of centres to keep from each, m, (agents,); negative for nobody.
    :param moves: ways of a step to choose from, m, (moves, 2).
    :param room: number of positions that there is memory for, a power of two.
    :param path: written, m, (steps + 1, 2).
    """
    last, agents = position.shape[0], position.shape[1]
    nodes = Nodes(
        np.empty((room, 2)), np.empty(room, np.int32), np.empty(room, np.int32),
        np.empty(room, np.int32), np.full(FINENESS * (last + 1) + 1, -1, np.int32),
        np.full(2 * room, -1, np.int64),
    )  # fmt: skip
    near, steps, arrival = np.empty((agents, 5)), last + 1, -1
    remaining = remaining_steps(trip, trip.start_x, trip.start_y)
    if math.ceil(remaining) > last:
        return UNSOLVED
    add_node(nodes, 0, trip.start_x, trip.start_y, 0, -1, remaining)
    count, estimate = 1, 0
    while estimate < nodes.first.size:
        node = nodes.first[estimate]
        if node < 0:
            estimate += 1
            continue
        nodes.first[estimate] = nodes.following[node]
        layer, x, y = nodes.layer[node], nodes.place[node, 0], nodes.place[node, 1]
        if layer + max(1.0, remaining_steps(trip, x, y)) > steps - 1:
            continue
        people = choose_near(trip, position, velocity, keep, layer, x, y, near)
        ahead_x, ahead_y = trip.goal_x - x, trip.goal_y - y
        share = min(1.0, trip.stride / max(math.sqrt(ahead_x**2 + ahead_y**2), 1e-12))
        for action in range(-1, moves.shape[0]):
            if action < 0:
                move_x, move_y = ahead_x * share, ahead_y * share
            else:
                move_x, move_y = moves[action, 0], moves[action, 1]
            to_x, to_y = x + move_x, y + move_y
            remaining = remaining_steps(trip, to_x, to_y)
            if layer + 1 + math.ceil(remaining) >= steps or outside(trip, to_x, to_y):
                continue
            slot = free_slot(trip, nodes.table, layer + 1, to_x, to_y)
            if slot < 0 or hits(near, people, move_x, move_y):
                continue
            if count == room:
                return NO_ROOM
            nodes.table[slot] = key_of(trip, layer + 1, to_x, to_y)
            add_node(nodes, count, to_x, to_y, layer + 1, node, remaining)
            if remaining <= 0.0:
                steps, arrival = layer + 1, count
            count += 1
    if arrival < 0:
        return UNSOLVED
    node = arrival
    while node >= 0:
        path[nodes.layer[node], 0] = nodes.place[node, 0]
        path[nodes.layer[node], 1] = nodes.place[node, 1]
        node = nodes.parent[node]
    return steps


@inlined
def remaining_steps(trip, x, y):  # type: ignore[no-untyped-def]
    """Return how many steps the straight line still takes, 0 where the robot has arrived."""
    distance = math.sqrt((trip.goal_x - x) ** 2 + (trip.goal_y - y) ** 2)
    return max(0.0, (distance - trip.tolerance) / trip.stride)


@inlined
def outside(trip, x, y):  # type: ignore[no-untyped-def]
    """Return whether the rim of the robot is behind a wall."""
    return max(abs(x), abs(y)) > trip.limit


@inlined
def add_node(nodes, node, x, y, layer, parent, remaining):  # type: ignore[no-untyped-def]
    """Write a node and put it first among those of its estimate."""
    nodes.place[node, 0], nodes.place[node, 1] = x, y
    nodes.layer[node], nodes.parent[node] = layer, parent
    estimate = int((layer + remaining) * FINENESS)
    nodes.following[node] = nodes.first[estimate]
    nodes.first[estimate] = node


@inlined
def key_of(trip, layer, x, y):  # type: ignore[no-untyped-def]
    """Return the number of the cell of a position in a layer."""
    column = int(math.floor((x - trip.start_x) / trip.cell)) + (1 << 20)
    row = int(math.floor((y - trip.start_y) / trip.cell)) + (1 << 20)
    return (layer << 42) | (column << 21) | row


@inlined
def free_slot(trip, table, layer, x, y):  # type: ignore[no-untyped-def]
    """Return where the key of a position belongs in the table, -1 where its cell is taken."""
    key = key_of(trip, layer, x, y)
    mask = np.uint64(table.size - 1)
    slot = np.int64(((np.uint64(key) * SPREAD) >> np.uint64(20)) & mask)
    while table[slot] >= 0:
        if table[slot] == key:
            return -1
        slot = (slot + 1) & (table.size - 1)
    return slot


@inlined
def choose_near(trip, position, velocity, keep, layer, x, y, near):  # type: ignore[no-untyped-def]
    """Write whom a step can reach: offset, own way and distance to keep; return their number."""
    count = 0
    for i in range(keep.size):
        walk_x = velocity[layer, i, 0] * trip.duration
        walk_y = velocity[layer, i, 1] * trip.duration
        offset_x, offset_y = position[layer, i, 0] - x, position[layer, i, 1] - y
        reach = keep[i] + trip.stride + math.sqrt(walk_x * walk_x + walk_y * walk_y)
        if keep[i] >= 0.0 and offset_x * offset_x + offset_y * offset_y < reach * reach:
            near[count, 0], near[count, 1] = offset_x, offset_y
            near[count, 2], near[count, 3], near[count, 4] = walk_x, walk_y, keep[i]
            count += 1
    return count


@inlined
def hits(near, count, move_x, move_y):  # type: ignore[no-untyped-def]
    """Return whether a step comes too near to anybody, by the simulator's own rule."""
    for i in range(count):
        least = swept_distance(near[i, 0], near[i, 1], near[i, 2] - move_x, near[i, 3] - move_y)
        if least < near[i, 4]:
            return True
    return False
