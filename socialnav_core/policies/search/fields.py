"""Distances to goals as the search reads them, and how they are kept."""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled, inlined
from socialnav_core.config import SearchConfig
from socialnav_core.policies.search.costs import length
from socialnav_core.policies.search.geodesic import (
    BOUNDS,
    CORNER_X,
    CORNER_Y,
    DISCS,
    GOAL_X,
    GOAL_Y,
    HEAD,
    ROBOT_RADIUS,
    solve,
)
from socialnav_core.policies.search.worlds import Worlds

SHIFTS = 4
"""The window moves by this part of its half-width, so that it does not move at every step."""
PROBE = 0.15
"""Distance over which the slope of a field is measured, m."""
IN_SIGHT = 0.005
"""Detours shorter than this count as none, m."""
NOTHING_IN_THE_WAY = -1


class Fields(NamedTuple):
    """Distances to goals on windows, one window a slot."""

    distance: np.ndarray  # m, float32 (slots, side, side)
    corner: np.ndarray  # centre of the first cell, m, (slots, 2)
    size: np.ndarray  # cells along a side that are used, (slots,)
    keys: np.ndarray  # what a slot was computed for, (slots, numbers)
    used: np.ndarray  # when it was asked for last, (slots,)
    clock: np.ndarray  # counts the requests, (1,)
    grid: float  # side of a cell, m
    window: float  # half-width of the largest window, m


class Frame(NamedTuple):
    """Where a field lies; without an obstacle there is none, and distances are straight lines."""

    x: float  # centre of the first cell, m
    y: float
    cells: float  # in a metre
    last: float  # number of the last cell along a side, -1 without a field


class GeodesicCache:
    """
    Keeps distances to goals until obstacles, goal or window change.

    A field is found again by what it was computed from, not by the number of its world: it does
    not matter whether worlds start anew, become fewer or change places.
    """

    def __init__(self, settings: SearchConfig) -> None:
        """Begin without any field; the settings say how large and fine they are."""
        self._settings = settings
        self.fields = make_fields(settings, 1, 0)

    def slots_of(self, worlds: Worlds) -> np.ndarray:
        """Return where the field of each world is, NOTHING_IN_THE_WAY without one, (batch,)."""
        slots = np.full(len(worlds.radius), NOTHING_IN_THE_WAY)
        obstacles = int(worlds.obstacles.sum(axis=1).max(initial=0))
        if obstacles == 0:
            return slots
        # twice as many as worlds: a robot at the edge between two windows needs both in turn
        needed, numbers = 2 * len(slots), HEAD + 3 * obstacles
        if needed > len(self.fields.used) or numbers > self.fields.keys.shape[1]:
            self.fields = make_fields(self._settings, needed, obstacles)
        find_fields(worlds, self.fields, slots)
        return slots


def make_fields(settings: SearchConfig, slots: int, obstacles: int) -> Fields:
    """Return fields of a number of slots, each for up to a number of obstacles; none is known."""
    side = 2 * math.ceil(settings.window / settings.grid) + 1
    return Fields(
        np.empty((slots, side, side), np.float32), np.zeros((slots, 2)),
        np.zeros(slots, np.int64), np.full((slots, HEAD + 3 * obstacles), np.nan),
        np.zeros(slots, np.int64), np.zeros(1, np.int64), settings.grid, settings.window,
    )  # fmt: skip


@compiled
def find_fields(worlds, fields, slots):  # type: ignore[no-untyped-def]
    """Write the slot of each world that has obstacles, computing the fields that are missing."""
    side = fields.distance.shape[1]
    key = np.empty(fields.keys.shape[1])
    slow, distance = np.empty((side, side)), np.empty((side, side))
    for world in range(slots.size):
        size = describe(worlds, fields, world, key)
        if key[DISCS] == 0.0:
            continue
        fields.clock[0] += 1
        slot = known_slot(fields, key)
        if slot < 0:
            slot = np.argmin(fields.used)
            fields.keys[slot] = key
            fields.corner[slot, 0], fields.corner[slot, 1] = key[CORNER_X], key[CORNER_Y]
            fields.size[slot] = size
            solve(key, size, fields.grid, slow, distance)
            fields.distance[slot, :size, :size] = distance[:size, :size]
        fields.used[slot] = fields.clock[0]
        slots[world] = slot


@inlined
def describe(worlds, fields, world, key):  # type: ignore[no-untyped-def]
    """Write what determines the field of a world, and return the size of its window."""
    bounds, grid = worlds.bounds[world], fields.grid
    key[:] = 0.0
    key[GOAL_X], key[GOAL_Y] = worlds.goal[world, 0], worlds.goal[world, 1]
    key[ROBOT_RADIUS], key[BOUNDS] = worlds.radius[world], bounds
    walled = bounds <= fields.window  # the window is the world
    half = math.ceil(min(bounds, fields.window) / grid)
    shift = fields.window / SHIFTS
    for axis in range(2):
        centre = 0.0 if walled else shift * round(worlds.position[world, axis] / shift)
        key[CORNER_X + axis] = centre - half * grid
    count = 0
    for i in range(worlds.radii.shape[1]):
        if worlds.obstacles[world, i]:
            place = HEAD + 3 * count
            key[place], key[place + 1] = worlds.agents[world, i, 0], worlds.agents[world, i, 1]
            key[place + 2] = worlds.radii[world, i]
            count += 1
    key[DISCS] = count
    return 2 * half + 1


@inlined
def known_slot(fields, key):  # type: ignore[no-untyped-def]
    """Return the slot whose field was computed for a key, -1 where there is none."""
    for slot in range(fields.used.size):
        same = True
        for i in range(key.size):
            if fields.keys[slot, i] != key[i]:
                same = False
                break
        if same:
            return slot
    return -1


@inlined
def interpolated(field, last, u, v):  # type: ignore[no-untyped-def]
    """
    Return a field between its cells, bilinear; outside, the rim's value and the way to the rim.

    There is no branch: so numba sees that it need not count references to the field.

    :param last: number of the last cell along a side.
    :param u: place along the first axis, in cells.
    """
    inside_u, inside_v = min(max(u, 0.0), last), min(max(v, 0.0), last)
    i, j = int(min(inside_u, last - 1.0)), int(min(inside_v, last - 1.0))
    a, b = inside_u - i, inside_v - j
    near = (1.0 - b) * field[i, j] + b * field[i, j + 1]
    far = (1.0 - b) * field[i + 1, j] + b * field[i + 1, j + 1]
    return (1.0 - a) * near + a * far


@inlined
def distance_at(field, frame, x, y, goal_x, goal_y):  # type: ignore[no-untyped-def]
    """Return the distance to the goal from a point, m."""
    if frame.last < 0.0:
        return length(goal_x - x, goal_y - y)
    u, v = (x - frame.x) * frame.cells, (y - frame.y) * frame.cells
    return interpolated(field, frame.last, u, v)


@inlined
def way_down(field, frame, x, y, goal_x, goal_y):  # type: ignore[no-untyped-def]
    """Return the unit vector in which the distance to the goal falls fastest, and the distance."""
    distance = distance_at(field, frame, x, y, goal_x, goal_y)
    down_x, down_y = slope(field, frame, x, y, goal_x, goal_y, distance)
    return down_x, down_y, distance


@inlined
def slope(field, frame, x, y, goal_x, goal_y, distance):  # type: ignore[no-untyped-def]
    """
    Return the unit vector in which the distance to the goal falls fastest.

    :param distance: to the goal from there, m.
    """
    ahead_x, ahead_y = goal_x - x, goal_y - y
    straight = length(ahead_x, ahead_y)
    if distance > straight + IN_SIGHT and straight > PROBE:
        u, v = (x - frame.x) * frame.cells, (y - frame.y) * frame.cells
        probe = PROBE * frame.cells
        ahead_x = interpolated(field, frame.last, u - probe, v)
        ahead_x -= interpolated(field, frame.last, u + probe, v)
        ahead_y = interpolated(field, frame.last, u, v - probe)
        ahead_y -= interpolated(field, frame.last, u, v + probe)
    scale = 1.0 / max(length(ahead_x, ahead_y), 1e-9)
    return ahead_x * scale, ahead_y * scale


@inlined
def frame_of(fields, slot):  # type: ignore[no-untyped-def]
    """Return where the field of a slot lies."""
    if slot < 0:
        return Frame(0.0, 0.0, 1.0 / fields.grid, -1.0)
    last = fields.size[slot] - 1.0
    return Frame(fields.corner[slot, 0], fields.corner[slot, 1], 1.0 / fields.grid, last)
