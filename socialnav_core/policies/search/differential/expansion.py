"""One layer of the search from the layer before."""

import math

from socialnav_core.compilation import compiled
from socialnav_core.policies.search.costs import length
from socialnav_core.policies.search.differential.arcs import arc_hits_disc
from socialnav_core.policies.search.differential.cells import cell_number, place_of
from socialnav_core.policies.search.differential.lattice import (
    HEADING,
    SPEED,
    SPENT,
    TOTAL,
    TURN_RATE,
    X,
    Y,
)
from socialnav_core.policies.search.differential.moves import write_speeds, write_turns
from socialnav_core.policies.search.differential.remaining import (
    angle_between,
    driving_time,
    turning_time,
)
from socialnav_core.policies.search.differential.surprises import add_surprises, SPEEDS
from socialnav_core.policies.search.fields import distance_at, slope, way_down
from socialnav_core.policies.search.nearness import add_people, choose_near, choose_near_discs
from socialnav_core.policies.search.search import LEAST_REMAINING


@compiled
def expand(  # type: ignore[no-untyped-def]
    trip, base, field, frame, layer, count, cut, arrival, active, obstacles, lattice, costs, table,
    space,
):  # fmt: skip
    """
    Fill the next layer from the nodes of one.

    Return the number of its nodes, the least total among them and that of an arrival (inf for
    none). Cheap tests come first, as in the holonomic search.

    :param cut: nodes with a greater total are not followed.
    :param arrival: least total of an arrival so far.
    :param table: of `unavoidable`.
    """
    nodes, following, parent = space.nodes[layer], space.nodes[layer + 1], space.parent[layer + 1]
    occupant, cells, turns, speeds = space.occupant, space.cells, space.turns, space.speeds
    near, near_discs = space.near, space.near_discs
    arrival_node = following.shape[0] - 1
    duration, lag = lattice.durations[layer], lattice.lags[layer]
    fine = layer < lattice.fine_layers
    step, rate = trip.speed * duration, 1.0 / (trip.speed * lattice.cells[layer])
    contact, intrusion = lattice.contact[layer], lattice.intrusion[layer]
    per_turn_rate = lattice.steering / base.turn_rate
    per_speed = costs.turning / trip.speed
    surprise, backwards = lattice.surprise[layer], base.reverse * trip.speed
    rows = SPEEDS / (trip.speed + backwards)
    occupant[:] = -1
    filled, least, reached = 0, math.inf, math.inf
    for node in range(count):
        if nodes[node, TOTAL] > cut:
            continue
        x, y, heading = nodes[node, X], nodes[node, Y], nodes[node, HEADING]
        speed, turn_rate = nodes[node, SPEED], nodes[node, TURN_RATE]
        spent = nodes[node, SPENT] + duration
        people = choose_near(trip, layer, x, y, active, step, space)
        discs = choose_near_discs(x, y, step, obstacles, space)
        down_x, down_y, _ = way_down(field, frame, x, y, trip.goal_x, trip.goal_y)
        wall = max(trip.limit, max(abs(x), abs(y)))  # whoever is beyond may come back
        error = angle_between(math.cos(heading), math.sin(heading), down_x, down_y)
        turns_tried = write_turns(base, turn_rate, error, duration, lag, fine, turns)
        speeds_tried = write_speeds(base, trip.speed, speed, duration, fine, speeds)
        for i in range(turns_tried):
            to_turn_rate = turns[i]
            turned = (turn_rate + lag * (to_turn_rate - turn_rate)) * duration
            to_heading = heading + turned
            half = 0.5 * turned
            ahead_x, ahead_y = math.cos(heading + half), math.sin(heading + half)
            to_x_axis, to_y_axis = math.cos(to_heading), math.sin(to_heading)
            chord = duration * (math.sin(half) / half if abs(half) > 1e-6 else 1.0)
            steered = per_turn_rate * abs(to_turn_rate - turn_rate)
            for j in range(speeds_tried):
                to_speed = speeds[j]
                driven = speed + lag * (to_speed - speed)
                move_x, move_y = ahead_x * chord * driven, ahead_y * chord * driven
                to_x, to_y = x + move_x, y + move_y
                if max(abs(to_x), abs(to_y)) > wall:
                    continue
                so_far = spent + steered + per_speed * abs(to_speed - speed)
                goal_x, goal_y = trip.goal_x - to_x, trip.goal_y - to_y
                arrives = length(goal_x, goal_y) < trip.tolerance
                place, target, bound, remaining = 0, -1, min(arrival, reached), 0.0
                if not arrives:
                    bound = min(bound, least + lattice.slack)
                    distance = distance_at(field, frame, to_x, to_y, trip.goal_x, trip.goal_y)
                    left = max(distance - trip.tolerance, LEAST_REMAINING)
                    remaining = driving_time(base, trip.speed, left, to_speed)
                    if so_far + remaining >= bound:
                        continue
                    number = cell_number(
                        lattice, base, trip, rate, to_x, to_y, to_heading, to_speed, to_turn_rate
                    )
                    place = place_of(cells, occupant, number)
                    target = occupant[place]
                    if target >= 0:
                        bound = min(bound, following[target, TOTAL])
                    elif filled == arrival_node:
                        continue
                    if so_far + remaining >= bound:
                        continue
                    down_x, down_y = slope(
                        field, frame, to_x, to_y, trip.goal_x, trip.goal_y, distance
                    )
                    error = angle_between(to_x_axis, to_y_axis, down_x, down_y)
                    remaining += lattice.turn_loss * turning_time(
                        base, trip.speed, lattice.arc_share, left, error, to_turn_rate
                    )
                    cells[place] = number
                total = so_far + remaining
                if total >= bound:
                    continue
                if discs > 0:
                    quarter = 0.25 * turned
                    swept = 0.5 * driven * duration
                    bulge = 0.125 * abs(driven * duration * turned)
                    half_x = swept * math.cos(heading + quarter)
                    half_y = swept * math.sin(heading + quarter)
                    if arc_hits_disc(near_discs, discs, move_x, move_y, half_x, half_y, bulge):
                        continue
                total = add_people(
                    near, people, move_x, move_y, costs, layer, contact, intrusion, total, bound
                )
                if total >= bound:
                    continue
                if surprise > 0.0:
                    row = int(min(max((to_speed + backwards) * rows, 0.0), SPEEDS) + 0.5)
                    total = add_surprises(
                        near, people, move_x, move_y, to_x_axis, to_y_axis, row, table, surprise,
                        total,
                    )  # fmt: skip
                    if total >= bound:
                        continue
                if arrives:
                    reached, target = total, arrival_node
                else:
                    least = min(least, total)
                    if target < 0:
                        target = occupant[place] = filled
                        filled += 1
                following[target, X], following[target, Y] = to_x, to_y
                following[target, HEADING] = to_heading
                following[target, SPEED], following[target, TURN_RATE] = to_speed, to_turn_rate
                following[target, SPENT], following[target, TOTAL] = total - remaining, total
                parent[target] = node
    return filled, least, reached
