"""
Compiled kernel of optimal reciprocal collision avoidance; orca_velocities.py names its source.

The choice of neighbours, the order of constraints and the tolerance are those of the RVO2 library,
so velocities agree with it up to its single precision. A half-plane is a row (point x, point y,
direction x, direction y): the velocities on the left of its directed boundary line are permitted.

No view of an array is taken in a loop: numba would count references to it. All compiled functions
are in this one file: numba's cache does not notice a change of another one.
"""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled, inlined

PARALLEL_TOLERANCE = 1e-5
"""Sine of the angle below which two boundary lines count as parallel (RVO_EPSILON of RVO2)."""
SPARE_CANDIDATES = 16
"""Number of candidates beyond the greatest number of neighbours that are collected at a time."""
X, Y, VELOCITY_X, VELOCITY_Y, RADIUS, RESPONSIBILITY = range(6)
"""Rows of Workspace.crowd."""


class Bodies(NamedTuple):
    """Everybody in a batch of worlds; `orca_velocities` says more of what the fields mean."""

    position: np.ndarray
    """m, (batch, agents, 2)."""
    velocity: np.ndarray
    """m/s, (batch, agents, 2)."""
    preferred_velocity: np.ndarray
    """m/s, (batch, at least movers, 2)."""
    radius: np.ndarray
    """m, (batch, agents)."""
    max_speed: np.ndarray
    """m/s, (batch, at least movers)."""
    valid: np.ndarray
    """bool (batch, agents)."""
    responsibility: np.ndarray
    """Share of a conflict that others take, (batch, agents)."""
    neighbor_distance: np.ndarray
    """m, (batch, at least movers)."""


class Foresight(NamedTuple):
    """How much an agent takes into account."""

    max_neighbors: int
    time_horizon: float
    """s."""
    time_step: float
    """Within which discs that overlap already move apart, s."""


class Workspace(NamedTuple):
    """What the functions below read and write: one world, and one of its agents at a time."""

    crowd: np.ndarray
    candidates: np.ndarray
    squared_distances: np.ndarray
    ranks: np.ndarray
    neighbors: np.ndarray
    neighbor_squared_distances: np.ndarray
    lines: np.ndarray
    projected: np.ndarray
    inverse_horizon: float
    inverse_step: float


@inlined
def _make_workspace(agents: int, limit: int, time_horizon: float, time_step: float) -> Workspace:
    """Return the work space for worlds of a number of agents and a limit of neighbours."""
    neighbors = max(0, min(limit, agents - 1))
    candidates = min(agents, neighbors + SPARE_CANDIDATES)
    return Workspace(
        np.empty((6, agents)),
        np.empty(candidates, np.int64), np.empty(candidates), np.empty(candidates, np.int64),
        np.empty(neighbors, np.int64), np.empty(neighbors),
        np.empty((neighbors, 4)), np.empty((neighbors, 4)),
        1.0 / time_horizon, 1.0 / time_step,
    )  # fmt: skip


@inlined
def _rank_candidates(space: Workspace, count: int) -> int:
    """Write the nearest of `count` candidates as neighbours, in order, and return their number."""
    # Counting comparisons, unlike insertion, never branches on a distance, which is faster here.
    for later in range(count):
        squared, rank = space.squared_distances[later], later
        for earlier in range(later):
            behind = space.squared_distances[earlier] > squared
            space.ranks[earlier] += behind
            rank -= behind
        space.ranks[later] = rank
    for row in range(count):
        rank = space.ranks[row]
        if rank < space.neighbors.size:
            space.neighbors[rank] = space.candidates[row]
            space.neighbor_squared_distances[rank] = space.squared_distances[row]
    return min(count, space.neighbors.size)


@inlined
def _find_neighbors(space: Workspace, agents: int, agent: int, reach: float) -> int:
    """Write the agents with the nearest centres as neighbours, in order; return their number."""
    count, limit, x, y = 0, reach * reach, space.crowd[X, agent], space.crowd[Y, agent]
    for other in range(agents):
        offset_x, offset_y = x - space.crowd[X, other], y - space.crowd[Y, other]
        squared = offset_x * offset_x + offset_y * offset_y
        space.candidates[count], space.squared_distances[count] = other, squared
        count += (squared < limit) & (other != agent)
        if count == space.candidates.size:  # keep the nearest, forget whoever is farther away
            count = _rank_candidates(space, count)
            for row in range(count):
                space.candidates[row] = space.neighbors[row]
                space.squared_distances[row] = space.neighbor_squared_distances[row]
            limit = space.squared_distances[count - 1]
    return _rank_candidates(space, count)


@inlined
def _write_lines(space: Workspace, agent: int, count: int) -> None:
    """
    Write the half-planes that `count` neighbours impose on an agent (eqs. 3 to 5).

    The velocity obstacle of a pair is a cone whose tip is cut off by a disc. The least change of
    the relative velocity that leaves it, u, is normal to that disc or to one of the two legs.
    Discs that overlap already must part within one time step.
    """
    crowd = space.crowd
    for row in range(count):
        other = space.neighbors[row]
        x, y = crowd[X, other] - crowd[X, agent], crowd[Y, other] - crowd[Y, agent]
        velocity_x = crowd[VELOCITY_X, agent] - crowd[VELOCITY_X, other]
        velocity_y = crowd[VELOCITY_Y, agent] - crowd[VELOCITY_Y, other]
        radius = crowd[RADIUS, agent] + crowd[RADIUS, other]
        gap = x * x + y * y - radius * radius
        rate = space.inverse_horizon if gap > 0.0 else space.inverse_step
        w_x, w_y = velocity_x - rate * x, velocity_y - rate * y
        squared_w, along = w_x * w_x + w_y * w_y, w_x * x + w_y * y
        if gap > 0.0 and (along >= 0.0 or along * along <= radius * radius * squared_w):
            leg, scale = math.sqrt(gap), 1.0 / (x * x + y * y)
            leg = leg if x * w_y > y * w_x else -leg
            normal_x, normal_y = scale * (-x * radius - y * leg), scale * (x * leg - y * radius)
            u = -velocity_x * normal_x - velocity_y * normal_y
        else:
            length = math.sqrt(squared_w)
            u = rate * radius - length
            scale = 1.0 / length
            normal_x, normal_y = w_x * scale, w_y * scale
            if length == 0.0:  # all ways are equally short; the two of a pair take opposite ones
                normal_x, normal_y = math.copysign(1.0, other - agent), 0.0
        u *= crowd[RESPONSIBILITY, other]
        space.lines[row, 0] = crowd[VELOCITY_X, agent] + u * normal_x
        space.lines[row, 1] = crowd[VELOCITY_Y, agent] + u * normal_y
        space.lines[row, 2], space.lines[row, 3] = normal_y, -normal_x


@inlined
def _excess(lines: np.ndarray, number: int, x: float, y: float) -> float:
    """Return by how much a velocity lies outside a half-plane, m/s; negative inside."""
    return lines[number, 2] * (lines[number, 1] - y) - lines[number, 3] * (lines[number, 0] - x)


@inlined
def _permitted_interval(
    lines: np.ndarray, number: int, max_speed: float
) -> tuple[bool, float, float]:
    """Return (feasible, first, last): what earlier lines permit of one, m/s from its point."""
    point_x, point_y = lines[number, 0], lines[number, 1]
    direction_x, direction_y = lines[number, 2], lines[number, 3]
    along = point_x * direction_x + point_y * direction_y
    discriminant = along * along + max_speed * max_speed - point_x * point_x - point_y * point_y
    if discriminant < 0.0:
        return False, 0.0, 0.0
    half_chord = math.sqrt(discriminant)
    first, last = -along - half_chord, -along + half_chord
    for earlier in range(number):
        sine = direction_x * lines[earlier, 3] - direction_y * lines[earlier, 2]
        slack = -_excess(lines, earlier, point_x, point_y)
        if abs(sine) <= PARALLEL_TOLERANCE:
            if slack < 0.0:
                return False, 0.0, 0.0
            continue
        crossing = slack / sine
        if sine > 0.0:
            last = min(last, crossing)
        else:
            first = max(first, crossing)
        if first > last:
            return False, 0.0, 0.0
    return True, first, last


@inlined
def _best_velocity(
    lines: np.ndarray, count: int, max_speed: float, aim_x: float, aim_y: float, farthest: bool
) -> tuple[int, float, float]:
    """
    Return the best velocity that all half-planes permit, by an incremental linear programme.

    :param aim_x: The velocity to be near, m/s; if `farthest`, a unit vector to go far along.
    :return: (number of half-planes satisfied, velocity x, velocity y). A number below `count`
        is the first half-plane that cannot be satisfied together with the earlier ones.
    """
    aim_speed = math.sqrt(aim_x * aim_x + aim_y * aim_y)
    scale = max_speed / aim_speed if farthest or aim_speed > max_speed else 1.0
    x, y = aim_x * scale, aim_y * scale
    for number in range(count):
        if _excess(lines, number, x, y) <= 0.0:
            continue
        feasible, first, last = _permitted_interval(lines, number, max_speed)
        if not feasible:
            return number, x, y
        point_x, point_y = lines[number, 0], lines[number, 1]
        direction_x, direction_y = lines[number, 2], lines[number, 3]
        if farthest:
            along = last if aim_x * direction_x + aim_y * direction_y > 0.0 else first
        else:
            along = direction_x * (aim_x - point_x) + direction_y * (aim_y - point_y)
            along = min(max(along, first), last)
        x, y = point_x + along * direction_x, point_y + along * direction_y
    return count, x, y


@inlined
def _equal_excess_lines(lines: np.ndarray, number: int, projected: np.ndarray) -> int:
    """Write the half-planes where an earlier line is exceeded less than this; return how many."""
    count = 0
    point_x, point_y = lines[number, 0], lines[number, 1]
    direction_x, direction_y = lines[number, 2], lines[number, 3]
    for earlier in range(number):
        other_x, other_y = lines[earlier, 2], lines[earlier, 3]
        sine = direction_x * other_y - direction_y * other_x
        if abs(sine) > PARALLEL_TOLERANCE:
            along = -_excess(lines, earlier, point_x, point_y) / sine
            projected[count, 0] = point_x + along * direction_x
            projected[count, 1] = point_y + along * direction_y
        elif direction_x * other_x + direction_y * other_y > 0.0:
            continue
        else:
            projected[count, 0] = 0.5 * (point_x + lines[earlier, 0])
            projected[count, 1] = 0.5 * (point_y + lines[earlier, 1])
        turn_x, turn_y = other_x - direction_x, other_y - direction_y
        length = math.sqrt(turn_x * turn_x + turn_y * turn_y)
        projected[count, 2], projected[count, 3] = turn_x / length, turn_y / length
        count += 1
    return count


@inlined
def _least_excess_velocity(
    space: Workspace, count: int, begin: int, max_speed: float, x: float, y: float
) -> tuple[float, float]:
    """Return the velocity that exceeds all lines least; (x, y) keeps to those before `begin`."""
    excess, lines = 0.0, space.lines
    for number in range(begin, count):
        if _excess(lines, number, x, y) > excess:
            others = _equal_excess_lines(lines, number, space.projected)
            satisfied, best_x, best_y = _best_velocity(
                space.projected, others, max_speed, -lines[number, 3], lines[number, 2], True
            )
            # Infeasible only through rounding: (x, y) satisfies the projected lines by definition.
            if satisfied == others:
                x, y = best_x, best_y
            excess = _excess(lines, number, x, y)
    return x, y


def orca_step(
    bodies: Bodies, foresight: Foresight, active: np.ndarray, movers: int, out: np.ndarray
) -> None:
    """
    Write the ORCA velocities of the first `movers` agents of each active world into `out`.

    Nothing is checked. Arrays are C-contiguous float64, masks bool; another layout costs a
    compilation.

    :param active: (batch,) bool; an inactive world costs nothing and keeps its rows of `out`.
    :param out: (batch, at least movers, 2), an array of its own.
    """
    _step(tuple(bodies), tuple(foresight), active, movers, out)


# Cached alone, since it holds the code of the functions above. Named tuples come as plain ones: at
# each call numba asks Python for the type of a named one.
@compiled
def _step(bodies, foresight, active, movers, out):  # type: ignore[no-untyped-def]
    """Fill the array of orca_step."""
    seen, until = Bodies(*bodies), Foresight(*foresight)
    space = _make_workspace(
        seen.position.shape[1], until.max_neighbors, until.time_horizon, until.time_step
    )
    for world in range(seen.position.shape[0]):
        if not active[world]:
            continue
        agents, column = 0, 0
        for agent in range(seen.position.shape[1]):
            space.crowd[X, agents] = seen.position[world, agent, 0]
            space.crowd[Y, agents] = seen.position[world, agent, 1]
            space.crowd[VELOCITY_X, agents] = seen.velocity[world, agent, 0]
            space.crowd[VELOCITY_Y, agents] = seen.velocity[world, agent, 1]
            space.crowd[RADIUS, agents] = seen.radius[world, agent]
            space.crowd[RESPONSIBILITY, agents] = seen.responsibility[world, agent]
            agents += seen.valid[world, agent]
        for agent in range(movers):
            x = y = 0.0
            if seen.valid[world, agent]:
                speed = seen.max_speed[world, agent]
                reach = seen.neighbor_distance[world, agent]
                count = _find_neighbors(space, agents, column, reach)
                _write_lines(space, column, count)
                x = seen.preferred_velocity[world, agent, 0]
                y = seen.preferred_velocity[world, agent, 1]
                satisfied, x, y = _best_velocity(space.lines, count, speed, x, y, False)
                if satisfied < count:
                    x, y = _least_excess_velocity(space, count, satisfied, speed, x, y)
                column += 1
            out[world, agent, 0], out[world, agent, 1] = x, y
