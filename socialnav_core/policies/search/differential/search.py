"""
The search over arcs: forward dynamic programming with a beam, one layer a step of time.

A node is an exact pose with the speed and the turn rate that led there; of those that fall into
one cell of a layer the cheapest is kept. All costs are in seconds.
"""

import math

import numpy as np

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.candidates import write_candidates
from socialnav_core.policies.search.differential.ends import write_ends
from socialnav_core.policies.search.differential.expansion import expand
from socialnav_core.policies.search.differential.lattice import (
    HEADING,
    SPEED,
    SPENT,
    TOTAL,
    TURN_RATE,
    X,
    Y,
)
from socialnav_core.policies.search.differential.surprises import REACH as SURPRISE_REACH
from socialnav_core.policies.search.fields import frame_of
from socialnav_core.policies.search.lattice import REACH
from socialnav_core.policies.search.nearness import choose_active
from socialnav_core.policies.search.scene import gather_obstacles, gather_people
from socialnav_core.policies.search.search import trip_of, write_plan

BINS = 64
"""Totals are counted in so many bins between the best and the slack, to find the beam's end."""


@compiled
def plan_worlds(  # type: ignore[no-untyped-def]
    worlds, present, base, slots, fields, positions, deviations, weights, lattice, costs, tables,
    chosen, space, candidate_slack, candidates, ends, commands, plans, totals,
):  # fmt: skip
    """
    Plan in each world.

    Write commands, m/s and rad/s, plans, m, (batch, layers, 2), and expected costs, s.

    :param present: headings, speeds and turn rates, (batch, 3).
    :param slots: where the distances of each world are in the fields.
    :param tables: of `unavoidable`, one for each speed of a robot.
    :param chosen: which of them is that of a world, (batch,).
    :param candidate_slack: how much worse than the best a candidate may be, s.
    :param candidates: written where the robot does not arrive within the horizon.
    :param ends: of the candidates.
    """
    for world in range(slots.size):
        if worlds.speed[world] <= 0.0:
            commands[world], plans[world], totals[world] = 0.0, worlds.position[world], math.inf
            continue
        people = gather_people(
            worlds, world, positions, deviations, weights, lattice, costs, space
        )
        if lattice.surprise[0] > 0.0:
            widen_reach(people, lattice, space)
        obstacles = gather_obstacles(worlds, world, lattice, costs, space)
        field, frame = fields.distance[max(0, slots[world])], frame_of(fields, slots[world])
        start_node(worlds, world, present, base, space)
        layer, node, count = search(
            worlds, world, base, field, frame, people, obstacles, lattice, costs,
            tables[chosen[world]], space,
        )  # fmt: skip
        totals[world] = space.nodes[layer, node, TOTAL]
        write_candidates(world, count, totals[world], candidate_slack, space, candidates)
        write_ends(world, space, candidates, ends)
        write_plan(world, layer, node, space, plans)
        write_command(world, layer, node, base, lattice, space, commands)


@inlined
def widen_reach(people, lattice, space):  # type: ignore[no-untyped-def]
    """Let people count from as far away as they can surprise the robot."""
    for layer in range(space.spread.shape[0]):
        if lattice.surprise[layer] == 0.0:
            break
        for person in range(people):
            space.spread[layer, person, REACH] = max(
                space.spread[layer, person, REACH], SURPRISE_REACH
            )


@inlined
def start_node(worlds, world, present, base, space):  # type: ignore[no-untyped-def]
    """Write the robot as the first node, within its limits."""
    first, fastest = space.nodes[0, 0], worlds.speed[world]
    first[X], first[Y] = worlds.position[world, 0], worlds.position[world, 1]
    first[HEADING] = present[world, 0]
    first[SPEED] = min(max(present[world, 1], -fastest), fastest)
    first[TURN_RATE] = min(max(present[world, 2], -base.turn_rate), base.turn_rate)
    first[SPENT] = first[TOTAL] = 0.0


@compiled
def search(  # type: ignore[no-untyped-def]
    worlds, world, base, field, frame, people, obstacles, lattice, costs, table, space
):
    """
    Fill the layers of a world.

    Return the layer and number of the node to head for, and how many nodes the last layer has; 0
    where the robot is to arrive or has no way.
    """
    trip = trip_of(worlds, world, costs)
    arrival_node = space.nodes.shape[1] - 1
    count, cut, arrival, arrival_layer = 1, math.inf, math.inf, 0
    driven, node = 0.0, 0
    for layer in range(lattice.durations.size):
        active = choose_active(trip, layer, people, driven, lattice, space)
        filled, best, reached = expand(
            trip, base, field, frame, layer, count, cut, arrival, active, obstacles, lattice,
            costs, table, space,
        )  # fmt: skip
        if reached < arrival:
            arrival, arrival_layer = reached, layer + 1
        if arrival <= best:
            return arrival_layer, arrival_node, 0
        if filled == 0:
            return layer, best_node(space.nodes[layer], count), 0
        count, cut = filled, beam_end(space.nodes[layer + 1], filled, best, lattice)
        driven += trip.speed * lattice.durations[layer]
    last = lattice.durations.size
    node = best_node(space.nodes[last], count)
    if arrival < space.nodes[last, node, TOTAL]:
        return arrival_layer, arrival_node, 0
    return last, node, count


@inlined
def best_node(nodes, count):  # type: ignore[no-untyped-def]
    """Return the node of a layer with the least total."""
    best = 0
    for node in range(count):
        if nodes[node, TOTAL] < nodes[best, TOTAL]:
            best = node
    return best


@inlined
def beam_end(nodes, count, best, lattice):  # type: ignore[no-untyped-def]
    """Return the total up to which nodes are followed: about as many as the beam is wide."""
    if count <= lattice.beam:
        return best + lattice.slack
    histogram = np.zeros(BINS, np.int64)
    scale = BINS / lattice.slack
    for node in range(count):
        place = (nodes[node, TOTAL] - best) * scale
        if place < BINS:
            histogram[int(place)] += 1
    followed = histogram[0]
    for place in range(1, BINS):
        followed += histogram[place]
        if followed > lattice.beam:
            return best + place / scale
    return best + lattice.slack


@inlined
def write_command(world, layer, node, base, lattice, space, commands):  # type: ignore[no-untyped-def]
    """Write the first command on the way to a node; without a way, the hardest braking."""
    if layer == 0:
        speed, change = space.nodes[0, 0, SPEED], base.acceleration * lattice.durations[0]
        commands[world, 0] = math.copysign(max(abs(speed) - change, 0.0), speed)
        turn_rate = space.nodes[0, 0, TURN_RATE]
        change = base.angular_acceleration * lattice.durations[0]
        commands[world, 1] = math.copysign(max(abs(turn_rate) - change, 0.0), turn_rate)
        return
    while layer > 1:
        node = space.parent[layer, node]
        layer -= 1
    commands[world, 0] = space.nodes[1, node, SPEED]
    commands[world, 1] = space.nodes[1, node, TURN_RATE]
