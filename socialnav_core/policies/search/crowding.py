"""
Distances to goals where people stand in the way.

A person who is predicted to be in the same place at the horizon makes the way through that place
longer, but closes nothing: who stands may go. How much longer ways become is found on cells twice
as wide as those of the distances around obstacles, with people and without them, and the
difference is added to the distances.
"""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import SearchConfig
from socialnav_core.policies.search.costs import length
from socialnav_core.policies.search.fields import (
    describe,
    Fields,
    make_fields,
    NOTHING_IN_THE_WAY,
)
from socialnav_core.policies.search.geodesic import (
    beyond,
    CORNER_X,
    CORNER_Y,
    GOAL_X,
    GOAL_Y,
    HEAD,
    mark_slow_cells,
    ROUNDS,
    SLOWNESS,
    sweep,
    UNKNOWN,
)
from socialnav_core.policies.search.worlds import Worlds
from socialnav_core.prediction import Prediction

COARSE = 2
"""Cells along each axis that become one."""
CONVERGED = 0.05
"""The sweeps of wide cells end when no distance changes by more than this, m."""
WALKING = 0.5
"""Whoever gets on by this part of the robot's preferred speed stands in nobody's way."""
LEAST_PRESENCE = 0.05
"""Whoever is in the way with less than this is left out."""
PARTS = 1024
"""Costs of a metre through people are whole numbers of this part."""


class Crowded(NamedTuple):
    """Distances with people in the way, one slot a world, and memory to find them."""

    fields: Fields
    ways: np.ndarray  # cost of a metre without people in wide cells, (worlds, side, side)
    empty: np.ndarray  # distances without people, m, (worlds, side, side)
    slow: np.ndarray  # cost of a metre with people, (side, side)
    distance: np.ndarray  # distances with people, m, (side, side)
    narrow: np.ndarray  # cost of a metre in the cells of the fields


class Crowding:
    """Adds people who stand in the way to distances to goals."""

    def __init__(self, settings: SearchConfig) -> None:
        """Keep the settings; no world is known."""
        self._settings = settings
        self._crowded = make_crowded(settings, 0, 0)

    def add(
        self,
        worlds: Worlds,
        prediction: Prediction,
        horizon: float,
        fields: Fields,
        slots: np.ndarray,
    ) -> tuple[Fields, np.ndarray]:
        """
        Return fields with people in them, and where that of each world is.

        :param horizon: how far ahead the last step of the prediction is, s.
        :param fields: around obstacles alone, which stay as they are.
        :param slots: where that of each world is, NOTHING_IN_THE_WAY without one, (batch,).
        """
        batch = len(slots)
        if self._settings.crowding == 0.0:
            return fields, slots
        obstacles = int(worlds.obstacles.sum(axis=1).max(initial=0))
        rows, numbers = self._crowded.fields.keys.shape
        if rows < batch or numbers < HEAD + 3 * obstacles:
            self._crowded = make_crowded(self._settings, batch, obstacles)
        crowded_slots = np.full(batch, NOTHING_IN_THE_WAY)
        add_crowds(
            worlds, np.ascontiguousarray(prediction.positions[:, :, -1], dtype=np.float64),
            np.ascontiguousarray(prediction.deviations[:, :, -1], dtype=np.float64),
            np.ascontiguousarray(prediction.weights, dtype=np.float64),
            WALKING * horizon, self._settings.crowding, fields, slots, self._crowded,
            crowded_slots,
        )  # fmt: skip
        return self._crowded.fields, crowded_slots


def make_crowded(settings: SearchConfig, worlds: int, obstacles: int) -> Crowded:
    """Return memory for a number of worlds, of which nothing is known."""
    fields = make_fields(settings, worlds, obstacles)
    side = fields.distance.shape[1]
    wide = side // COARSE + 1
    return Crowded(
        fields, np.empty((worlds, wide, wide)), np.empty((worlds, wide, wide)),
        np.empty((wide, wide)), np.empty((wide, wide)), np.empty((side, side)),
    )  # fmt: skip


@compiled
def add_crowds(  # type: ignore[no-untyped-def]
    worlds, positions, deviations, weights, walk, cost, fields, slots, crowded, crowded_slots
):
    """
    Write the distances of each world that has a field or somebody in the way.

    :param positions: of people at the horizon, m, (batch, modes, agents, 2).
    :param deviations: m, (batch, modes, agents).
    :param walk: time at preferred speed of a way after which somebody is in nobody's way, s.
    :param cost: of a metre through somebody, besides the way, m.
    """
    own, grid = crowded.fields, COARSE * fields.grid
    key = np.empty(own.keys.shape[1])
    for world in range(slots.size):
        size, slot = describe(worlds, own, world, key), slots[world]
        wide = size // COARSE + 1
        if not (own.keys[world] == key).all():
            remember(crowded, world, key, size, wide)
        slow = crowded.slow
        slow[:wide, :wide] = crowded.ways[world, :wide, :wide]
        if slow_down(
            worlds, world, positions, deviations, weights, walk, cost, key, wide, grid, slow
        ):
            solve_wide(key, wide, grid, slow, crowded.distance)
            add_difference(crowded, world, fields, slot, key, size)
            crowded_slots[world] = world
        elif slot >= 0:
            own.distance[world, :size, :size] = fields.distance[slot, :size, :size]
            crowded_slots[world] = world


@compiled
def remember(crowded, world, key, size, wide):  # type: ignore[no-untyped-def]
    """Write what a world is without people."""
    own, ways, narrow = crowded.fields, crowded.ways[world], crowded.narrow
    own.keys[world], own.size[world] = key, size
    own.corner[world, 0], own.corner[world, 1] = key[CORNER_X], key[CORNER_Y]
    mark_slow_cells(key, size, own.grid, narrow)
    for i in range(wide):
        for j in range(wide):
            least = SLOWNESS  # the least around, so that narrow ways stay
            for near_i in range(max(0, COARSE * i - 1), min(size, COARSE * i + 2)):
                for near_j in range(max(0, COARSE * j - 1), min(size, COARSE * j + 2)):
                    least = min(least, narrow[near_i, near_j])
            ways[i, j] = least
    crowded.slow[:wide, :wide] = ways[:wide, :wide]
    solve_wide(key, wide, COARSE * own.grid, crowded.slow, crowded.distance)
    crowded.empty[world, :wide, :wide] = crowded.distance[:wide, :wide]


@compiled
def solve_wide(key, size, grid, slow, distance):  # type: ignore[no-untyped-def]
    """Write the distances to the goal of a key by sweeps alone: errors cancel."""
    distance[:size, :size] = UNKNOWN
    outside = beyond(key, size, grid)
    for i in range(size):
        for j in range(size):
            x, y = key[CORNER_X] + i * grid, key[CORNER_Y] + j * grid
            straight = length(key[GOAL_X] - x, key[GOAL_Y] - y)
            rim = min(i, j) == 0 or max(i, j) == size - 1
            if straight < 1.5 * grid or (rim and outside and slow[i, j] < SLOWNESS):
                distance[i, j] = straight * slow[i, j]
    for _ in range(ROUNDS):
        change = 0.0
        for order in range(4):
            change = max(change, sweep(size, grid, order & 1, order & 2, slow, distance))
        if change < CONVERGED:
            break


@compiled
def slow_down(  # type: ignore[no-untyped-def]
    worlds, world, positions, deviations, weights, walk, cost, key, size, grid, slow
):
    """Raise the cost of a metre where somebody will be in the way; return whether anybody is."""
    anybody = False
    for mode in range(positions.shape[1]):
        for agent in range(positions.shape[2]):
            if not worlds.people[world, agent]:
                continue
            x, y = positions[world, mode, agent, 0], positions[world, mode, agent, 1]
            walked = length(x - worlds.agents[world, agent, 0], y - worlds.agents[world, agent, 1])
            reach = worlds.radii[world, agent] + worlds.radius[world]
            deviation = max(deviations[world, mode, agent], 1e-3)
            # standing, times the probability that the centre is within the contact distance
            presence = 1.0 - walked / max(walk * worlds.speed[world], 1e-9)
            presence *= 1.0 - math.exp(-0.5 * (reach / deviation) ** 2)
            if presence < LEAST_PRESENCE:
                continue
            anybody = True
            # of a kind that sums exactly, so that the order of people does not matter
            added = round(weights[world, mode] * cost * presence * PARTS) / PARTS
            u, v, cells = (x - key[CORNER_X]) / grid, (y - key[CORNER_Y]) / grid, reach / grid
            for i in range(max(0, math.ceil(u - cells)), min(size, math.floor(u + cells) + 1)):
                for j in range(max(0, math.ceil(v - cells)), min(size, math.floor(v + cells) + 1)):
                    if (i - u) ** 2 + (j - v) ** 2 < cells * cells:
                        slow[i, j] += added
    return anybody


@compiled
def add_difference(crowded, world, fields, slot, key, size):  # type: ignore[no-untyped-def]
    """Write the distances of a world with what people add to them, bilinear between wide cells."""
    into, people, empty = crowded.fields.distance[world], crowded.distance, crowded.empty[world]
    for i in range(size):
        low_i, high_i = i // COARSE, (i + 1) // COARSE
        x = key[CORNER_X] + i * fields.grid
        for j in range(size):
            low_j, high_j = j // COARSE, (j + 1) // COARSE
            added = people[low_i, low_j] - empty[low_i, low_j]
            added += people[low_i, high_j] - empty[low_i, high_j]
            added += people[high_i, low_j] - empty[high_i, low_j]
            added += people[high_i, high_j] - empty[high_i, high_j]
            if slot >= 0:
                distance = fields.distance[slot, i, j]
            else:
                y = key[CORNER_Y] + j * fields.grid
                distance = length(key[GOAL_X] - x, key[GOAL_Y] - y)
            into[i, j] = distance + 0.25 * max(added, 0.0)
