"""
Distances to a goal around obstacles.

Where the goal is in sight the distance is the straight line, exactly. Elsewhere it solves the
eikonal equation by fast sweeping (Zhao, A fast sweeping method for eikonal equations, 2005) from
the cells that see the goal. Cells too near to obstacles or walls are slow rather than closed: a
robot that stands in one, or whose goal lies in one, still has a way.
"""

import math

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.costs import length

MARGIN = 0.03
"""Gap to obstacles and walls below which a cell is slow, m."""
SLOWNESS = 20.0
"""Cost of a metre in slow cells."""
UNKNOWN = 1e9
ROUNDS = 12
CONVERGED = 1e-3
GOAL_X, GOAL_Y, ROBOT_RADIUS, BOUNDS, CORNER_X, CORNER_Y, DISCS, HEAD = range(8)
"""Places in a key: what a field is computed from; x, y and radius of each disc follow HEAD."""


@compiled
def solve(key, size, grid, slow, distance):  # type: ignore[no-untyped-def]
    """
    Write the distances to the goal of a key.

    :param slow: work space: cost of a metre in a cell, 0 where the distance is known already.
    """
    mark_slow_cells(key, size, grid, slow)
    distance[:size, :size] = UNKNOWN
    if not measure_in_sight(key, size, grid, slow, distance):
        seed_out_of_sight(key, size, grid, slow, distance)
    for _ in range(ROUNDS):
        change = 0.0
        for order in range(4):
            change = max(change, sweep(size, grid, order & 1, order & 2, slow, distance))
        if change < CONVERGED:
            break


@compiled
def mark_slow_cells(key, size, grid, slow):  # type: ignore[no-untyped-def]
    """Write the cost of a metre in each cell."""
    slow[:size, :size] = 1.0
    margin = key[ROBOT_RADIUS] + MARGIN
    limit = key[BOUNDS] - margin
    for i in range(size):
        for j in range(size):
            if max(abs(key[CORNER_X] + i * grid), abs(key[CORNER_Y] + j * grid)) > limit:
                slow[i, j] = SLOWNESS
    for disc in range(int(key[DISCS])):
        place = HEAD + 3 * disc
        x, y = key[place] - key[CORNER_X], key[place + 1] - key[CORNER_Y]
        reach = key[place + 2] + margin
        for i in range(max(0, math.ceil((x - reach) / grid)), size):
            if i * grid > x + reach:
                break
            for j in range(max(0, math.ceil((y - reach) / grid)), size):
                if j * grid > y + reach:
                    break
                if (i * grid - x) ** 2 + (j * grid - y) ** 2 < reach * reach:
                    slow[i, j] = SLOWNESS


@compiled
def measure_in_sight(key, size, grid, slow, distance):  # type: ignore[no-untyped-def]
    """Write the straight line where no disc cuts it; return whether that is so anywhere."""
    any_in_sight = False
    for i in range(size):
        for j in range(size):
            x, y = key[CORNER_X] + i * grid, key[CORNER_Y] + j * grid
            if slow[i, j] == 1.0 and in_sight(key, x, y):
                distance[i, j] = length(key[GOAL_X] - x, key[GOAL_Y] - y)
                slow[i, j] = 0.0
                any_in_sight = True
    return any_in_sight


@inlined
def in_sight(key, x, y):  # type: ignore[no-untyped-def]
    """Return whether no enlarged disc cuts the straight line from a free point to the goal."""
    ahead_x, ahead_y = key[GOAL_X] - x, key[GOAL_Y] - y
    length2 = ahead_x * ahead_x + ahead_y * ahead_y
    for disc in range(int(key[DISCS])):
        place = HEAD + 3 * disc
        reach = key[place + 2] + key[ROBOT_RADIUS] + MARGIN
        offset_x, offset_y = key[place] - x, key[place + 1] - y
        along = offset_x * ahead_x + offset_y * ahead_y
        if along <= 0.0:
            continue
        if along >= length2:  # the goal is the nearest point of the line
            if (offset_x - ahead_x) ** 2 + (offset_y - ahead_y) ** 2 < reach * reach:
                return False
            continue
        across = offset_x * ahead_y - offset_y * ahead_x
        if across * across < reach * reach * length2:
            return False
    return True


@compiled
def seed_out_of_sight(key, size, grid, slow, distance):  # type: ignore[no-untyped-def]
    """
    Write distances to begin with where nobody in the window sees the goal.

    A goal in the window lies in a slow cell: its neighbours know their way. For one beyond it,
    the free cells of the rim take the straight line: the best guess without a map.
    """
    for i in range(size):
        for j in range(size):
            x, y = key[CORNER_X] + i * grid, key[CORNER_Y] + j * grid
            straight = length(key[GOAL_X] - x, key[GOAL_Y] - y)
            rim = min(i, j) == 0 or max(i, j) == size - 1
            if straight < 1.5 * grid or (rim and slow[i, j] == 1.0 and beyond(key, size, grid)):
                distance[i, j] = straight * slow[i, j]


@inlined
def beyond(key, size, grid):  # type: ignore[no-untyped-def]
    """Return whether the goal lies outside of the window."""
    x, y, side = key[GOAL_X] - key[CORNER_X], key[GOAL_Y] - key[CORNER_Y], (size - 1) * grid
    return min(x, y) < 0.0 or max(x, y) > side


@inlined
def sweep(size, grid, forward_i, forward_j, slow, distance):  # type: ignore[no-untyped-def]
    """Improve all distances once, in one of the four orders; return the largest improvement."""
    change = 0.0
    for row in range(size):
        i = row if forward_i else size - 1 - row
        for column in range(size):
            j = column if forward_j else size - 1 - column
            if slow[i, j] == 0.0:
                continue
            a, b = UNKNOWN, UNKNOWN
            if i > 0:
                a = distance[i - 1, j]
            if i < size - 1:
                a = min(a, distance[i + 1, j])
            if j > 0:
                b = distance[i, j - 1]
            if j < size - 1:
                b = min(b, distance[i, j + 1])
            step = slow[i, j] * grid
            # Godunov's upwind scheme: (d - a)^2 + (d - b)^2 = step^2, from one side if it must
            reached = min(a, b) + step
            if abs(a - b) < step:
                reached = 0.5 * (a + b + math.sqrt(2.0 * step * step - (a - b) ** 2))
            if reached < distance[i, j]:
                change = max(change, min(1.0, distance[i, j] - reached))
                distance[i, j] = reached
    return change
