"""
The search: forward dynamic programming over positions, one layer a step of time.

A node is an exact position; of those that fall into one cell of a layer the cheapest is kept. Its
total is the cost so far and the time that the distance to the goal still takes. All costs are in
seconds.
"""

import math
from typing import NamedTuple

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.candidates import write_candidates
from socialnav_core.policies.search.costs import costs_when_slow, length
from socialnav_core.policies.search.fields import distance_at, frame_of, way_down
from socialnav_core.policies.search.lattice import SPENT, TOTAL, VELOCITY_X, VELOCITY_Y, X, Y
from socialnav_core.policies.search.nearness import (
    add_people,
    choose_active,
    choose_near,
    choose_near_discs,
    hits_disc,
)
from socialnav_core.policies.search.scene import gather_obstacles, gather_people

LEAST_REMAINING = 0.02
"""Short of the goal at least this remains, m: an arrival is always better."""
ARRIVAL_SHARE = 0.98
"""Arrivals are planned a little within the tolerance."""
NEARER_SHARE = 0.5
"""Where the robot is within the tolerance and still asked, it must come nearer by this factor."""


class Trip(NamedTuple):
    """Where a robot is and wants to go."""

    home_x: float  # where the search begins, m
    home_y: float
    goal_x: float
    goal_y: float
    tolerance: float  # distance from the goal that counts as arrived, m
    speed: float  # preferred, m/s
    limit: float  # largest coordinate of the centre within the walls, m


@inlined
def trip_of(worlds, world, costs):  # type: ignore[no-untyped-def]
    """Return the trip of a world's robot."""
    return Trip(
        worlds.position[world, 0], worlds.position[world, 1],
        worlds.goal[world, 0], worlds.goal[world, 1],
        arrival_distance(worlds, world, costs), worlds.speed[world],
        worlds.bounds[world] - worlds.radius[world] - costs.obstacle_margin,
    )  # fmt: skip


@compiled
def plan_worlds(  # type: ignore[no-untyped-def]
    worlds, slots, fields, positions, deviations, weights, lattice, costs, space, usual_speed,
    candidate_slack, candidates, commands, plans, totals,
):  # fmt: skip
    """
    Plan in each world; write commands, m/s, plans, m, (batch, layers, 2), and expected costs, s.

    :param slots: where the distances of each world are in the fields.
    :param usual_speed: slower robots count people as more, m/s; see `costs_when_slow`.
    :param candidate_slack: how much worse than the best a candidate may be, s.
    :param candidates: written where the robot does not arrive within the horizon.
    """
    for world in range(slots.size):
        if worlds.speed[world] <= 0.0:
            commands[world], plans[world], totals[world] = 0.0, worlds.position[world], math.inf
            continue
        own_costs = costs_when_slow(costs, worlds.speed[world], usual_speed)
        people = gather_people(
            worlds, world, positions, deviations, weights, lattice, own_costs, space
        )
        obstacles = gather_obstacles(worlds, world, lattice, costs, space)
        field, frame = fields.distance[max(0, slots[world])], frame_of(fields, slots[world])
        start_nodes(worlds, world, lattice, space)
        layer, node, count = search(
            worlds, world, field, frame, people, obstacles, lattice, own_costs, space
        )
        totals[world] = space.nodes[layer, node, TOTAL]
        write_candidates(world, count, totals[world], candidate_slack, space, candidates)
        write_plan(world, layer, node, space, plans)
        for axis in range(2):
            moved = plans[world, 0, axis] - worlds.position[world, axis]
            commands[world, axis] = moved / lattice.durations[0]


@inlined
def start_nodes(worlds, world, lattice, space):  # type: ignore[no-untyped-def]
    """Write the robot as the first node, and the moves of the lattice."""
    for axis in range(2):
        space.nodes[0, 0, X + axis] = worlds.position[world, axis]
        space.nodes[0, 0, VELOCITY_X + axis] = worlds.velocity[world, axis]
    space.nodes[0, 0, SPENT] = space.nodes[0, 0, TOTAL] = 0.0
    for action in range(space.moves.shape[0]):
        for axis in range(2):
            space.moves[action, axis] = lattice.actions[action, axis] * worlds.speed[world]


@compiled
def search(worlds, world, field, frame, people, obstacles, lattice, costs, space):  # type: ignore[no-untyped-def]
    """
    Fill the layers of a world.

    Return the layer and number of the node to head for, and how many nodes the last layer has; 0
    where the robot is to arrive.
    """
    trip = trip_of(worlds, world, costs)
    arrival_node = space.nodes.shape[1] - 1
    count, best, arrival, arrival_layer = 1, 0.0, math.inf, 0
    driven, node = 0.0, 0
    for layer in range(lattice.durations.size):
        active = choose_active(trip, layer, people, driven, lattice, space)
        count, best, reached = expand(
            trip, field, frame, layer, count, best, arrival, active, obstacles, lattice, costs,
            space,
        )  # fmt: skip
        if reached < arrival:
            arrival, arrival_layer = reached, layer + 1
        if count == 0 or arrival <= best:
            return arrival_layer, arrival_node, 0
        driven += trip.speed * lattice.durations[layer]
    last = lattice.durations.size
    for other in range(count):
        if space.nodes[last, other, TOTAL] < space.nodes[last, node, TOTAL]:
            node = other
    if arrival < space.nodes[last, node, TOTAL]:
        return arrival_layer, arrival_node, 0
    return last, node, count


@inlined
def arrival_distance(worlds, world, costs):  # type: ignore[no-untyped-def]
    """
    Return within which distance of the goal a node counts as arrived, m.

    Whoever asks for a command does not think that the robot has arrived: within the tolerance it
    goes on, nearer and nearer, so that a smaller tolerance of theirs is met as well.
    """
    distance = length(
        worlds.goal[world, 0] - worlds.position[world, 0],
        worlds.goal[world, 1] - worlds.position[world, 1],
    )
    tolerance = ARRIVAL_SHARE * costs.goal_tolerance
    return tolerance if distance > tolerance else max(NEARER_SHARE * distance, 1e-9)


@compiled
def expand(  # type: ignore[no-untyped-def]
    trip, field, frame, layer, count, best, arrival, active, obstacles, lattice, costs, space
):
    """
    Fill the next layer from the nodes of one.

    Return the number of its nodes, the least total among them and that of an arrival (inf for
    none). Cheap tests come first: most motions fall to the bound or to a cheaper node in their
    cell before anybody's distance is computed.

    :param best: least total in this layer.
    :param arrival: least total of an arrival so far.
    """
    nodes, following, parent = space.nodes[layer], space.nodes[layer + 1], space.parent[layer + 1]
    occupant, moves, near, near_discs = space.occupant, space.moves, space.near, space.near_discs
    duration, width = lattice.durations[layer], lattice.width
    rate, pace, step = 1.0 / duration, 1.0 / trip.speed, trip.speed * duration
    cells, middle = pace / lattice.cells[layer], (width // 2) + 0.5
    contact = costs.contact * costs.contact_discount**layer
    intrusion = costs.intrusion * costs.intrusion_discount**layer * duration
    occupant[:] = -1
    filled, least, reached = 0, math.inf, math.inf
    for node in range(count):
        if nodes[node, TOTAL] > best + costs.slack:
            continue
        x, y, spent = nodes[node, X], nodes[node, Y], nodes[node, SPENT] + duration
        people = choose_near(trip, layer, x, y, active, step, space)
        discs = choose_near_discs(x, y, step, obstacles, space)
        down_x, down_y, distance = way_down(field, frame, x, y, trip.goal_x, trip.goal_y)
        down = min(step, distance)
        wall = max(trip.limit, max(abs(x), abs(y)))  # whoever is beyond may come back
        for action in range(-1, moves.shape[0]):
            if action < 0:
                move_x, move_y = down_x * down, down_y * down
            else:
                move_x, move_y = moves[action, 0] * duration, moves[action, 1] * duration
            to_x, to_y = x + move_x, y + move_y
            if max(abs(to_x), abs(to_y)) > wall:
                continue
            change_x = move_x * rate - nodes[node, VELOCITY_X]
            change_y = move_y * rate - nodes[node, VELOCITY_Y]
            so_far = spent + costs.turning * pace * length(change_x, change_y)
            arrives = length(trip.goal_x - to_x, trip.goal_y - to_y) < trip.tolerance
            place, target, bound, remaining = 0, -1, min(arrival, reached), 0.0
            if not arrives:
                bound = min(bound, least + costs.slack)
                remaining = distance_at(field, frame, to_x, to_y, trip.goal_x, trip.goal_y)
                remaining = pace * max(remaining - trip.tolerance, LEAST_REMAINING)
                place = int((to_x - trip.home_x) * cells + middle) * width
                place += int((to_y - trip.home_y) * cells + middle)
                target = occupant[place]
                if target >= 0:
                    bound = min(bound, following[target, TOTAL])
            total = so_far + remaining
            if total >= bound or hits_disc(near_discs, discs, move_x, move_y):
                continue
            total = add_people(
                near, people, move_x, move_y, costs, layer, contact, intrusion, total, bound
            )
            if total >= bound:
                continue
            if arrives:
                reached, target = total, following.shape[0] - 1
            else:
                least = min(least, total)
                if target < 0:
                    target = occupant[place] = filled
                    filled += 1
            following[target, X], following[target, Y] = to_x, to_y
            following[target, VELOCITY_X] = move_x * rate
            following[target, VELOCITY_Y] = move_y * rate
            following[target, SPENT], following[target, TOTAL] = total - remaining, total
            parent[target] = node
    return filled, least, reached


@inlined
def write_plan(world, layer, node, space, plans):  # type: ignore[no-untyped-def]
    """Write the positions that lead to a node; after it the robot is taken to stay there."""
    for later in range(layer, plans.shape[1]):
        plans[world, later, 0] = space.nodes[layer, node, X]
        plans[world, later, 1] = space.nodes[layer, node, Y]
    while layer > 0:
        plans[world, layer - 1, 0] = space.nodes[layer, node, X]
        plans[world, layer - 1, 1] = space.nodes[layer, node, Y]
        node = space.parent[layer, node]
        layer -= 1
