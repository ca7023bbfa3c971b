"""
How likely it is that nothing helps once somebody walks off anew.

People turn and start within a step, and a base with inertia needs time to get out of their way.
Where one person stands, seen from the robot, and how fast it drives decide what it still can do:
so this is tabulated once for a base, and the search only looks it up.
"""

import math

import numpy as np

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.costs import length
from socialnav_core.policies.search.lattice import CONTACT, FROM_X, FROM_Y, SHARE, WALK_X, WALK_Y

REACH = 1.6
"""Whoever is farther from the rim of the robot surprises nobody, m."""
CONTACT_DISTANCE = 0.6
"""Between the centres, in the table, m; others are looked up by their gap."""
CELL = 0.1
"""Side of the cells of the table, m."""
HALF = int((REACH + CONTACT_DISTANCE) / CELL) + 1
SPEEDS = 12
"""Cells of the speed from the fastest backwards to the fastest forwards."""
DIRECTIONS = 16
"""In so many directions somebody may walk off."""
STEP = 0.125
"""Motions are followed in such steps, s."""
STEPS = 14
"""So many steps they are followed."""


@compiled
def unavoidable(base, fastest, delay, walking):  # type: ignore[no-untyped-def]
    """
    Return the share of directions in which somebody who walks off cannot be evaded.

    The robot goes straight on until it sees that, then it tries to brake, to drive backwards as
    far as it may, to go on or to go faster, each straight on and with a turn to both sides.

    :param fastest: speed of the robot, m/s.
    :param delay: until the robot reacts, s.
    :param walking: speed of the person, m/s.
    :returns: by speed, place ahead and place to the side, (SPEEDS + 1, 2 HALF + 1, HALF + 1).
    """
    table = np.zeros((SPEEDS + 1, 2 * HALF + 1, HALF + 1))
    backwards = base.reverse * fastest
    escapes = np.empty((SPEEDS + 1, 12, STEPS, 2))
    for row in range(SPEEDS + 1):
        speed = row * (fastest + backwards) / SPEEDS - backwards
        write_escapes(base, fastest, delay, speed, escapes[row])
        for i in range(2 * HALF + 1):
            for j in range(HALF + 1):
                x, y = (i - HALF) * CELL, j * CELL
                if length(x, y) > CONTACT_DISTANCE + REACH:
                    continue
                caught = 0
                for k in range(DIRECTIONS):
                    angle = 2.0 * math.pi * k / DIRECTIONS
                    walk_x, walk_y = walking * math.cos(angle), walking * math.sin(angle)
                    caught += is_caught(escapes[row], x, y, walk_x, walk_y)
                table[row, i, j] = caught / DIRECTIONS
    return table


@compiled
def write_escapes(base, fastest, delay, speed, escapes):  # type: ignore[no-untyped-def]
    """Write where the robot would be after each step of each of its ways out, m."""
    for kind in range(4):
        for side in range(3):
            x, y, heading, now, turning = 0.0, 0.0, 0.0, speed, 0.0
            for step in range(STEPS):
                if (step + 1) * STEP > delay + 1e-9:
                    change = base.acceleration * STEP
                    wanted = (0.0, -base.reverse * fastest, now, fastest)[kind]
                    now += min(max(wanted - now, -change), change)
                    change = base.angular_acceleration * STEP * (side - 1)
                    turning = min(max(turning + change, -base.turn_rate), base.turn_rate)
                heading += turning * STEP
                x += now * STEP * math.cos(heading)
                y += now * STEP * math.sin(heading)
                escapes[3 * kind + side, step, 0] = x
                escapes[3 * kind + side, step, 1] = y


@inlined
def is_caught(escapes, x, y, walk_x, walk_y):  # type: ignore[no-untyped-def]
    """Return whether each way out leads into somebody; who overlaps already must only get away."""
    keep = min(CONTACT_DISTANCE, length(x, y) - 1e-6)
    for escape in range(escapes.shape[0]):
        free = True
        for step in range(STEPS):
            time = (step + 1) * STEP
            offset_x = x + walk_x * time - escapes[escape, step, 0]
            offset_y = y + walk_y * time - escapes[escape, step, 1]
            if offset_x * offset_x + offset_y * offset_y < keep * keep:
                free = False
                break
        if free:
            return False
    return True


@inlined
def add_surprises(  # type: ignore[no-untyped-def]
    near, count, move_x, move_y, axis_x, axis_y, row, table, cost, total
):
    """
    Return a total with what it costs that the people near the end of a motion may walk off.

    :param axis_x: where the robot looks then.
    :param row: of the table, for its speed then.
    :param cost: of somebody who cannot be evaded in any direction, s.
    """
    for i in range(count):
        x = near[i, FROM_X] + near[i, WALK_X] - move_x
        y = near[i, FROM_Y] + near[i, WALK_Y] - move_y
        distance = length(x, y)
        away = distance - near[i, CONTACT] + CONTACT_DISTANCE
        if away < REACH + CONTACT_DISTANCE:
            scale = max(away, 0.0) / (max(distance, 1e-9) * CELL)
            ahead = int((x * axis_x + y * axis_y) * scale + HALF + 0.5)
            aside = int(abs(y * axis_x - x * axis_y) * scale + 0.5)
            total += near[i, SHARE] * cost * table[row, ahead, aside]
    return total
