"""Who and what can matter to a node of the search, and what a motion from there costs."""

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.costs import cost_of_gap, length
from socialnav_core.policies.search.lattice import (
    CONTACT,
    CONTACT_DISTANCE,
    FROM_X,
    FROM_Y,
    GAP,
    INVERSE,
    INVERSE_DEVIATION,
    REACH,
    SHARE,
    WALK_X,
    WALK_Y,
    WEIGHT,
)
from socialnav_core.simulation.rewards import swept_distance


@compiled
def choose_active(trip, layer, people, driven, lattice, space):  # type: ignore[no-untyped-def]
    """Write who can matter to any node of a layer; return their number."""
    count = 0
    for person in range(people):
        reach = driven + reach_in_layer(trip, layer, person, lattice, space)
        offset_x = space.track[layer, person, 0] - trip.home_x
        offset_y = space.track[layer, person, 1] - trip.home_y
        if offset_x * offset_x + offset_y * offset_y < reach * reach:
            space.active[count] = person
            count += 1
    return count


@inlined
def reach_in_layer(trip, layer, person, lattice, space):  # type: ignore[no-untyped-def]
    """Return at which distance at the beginning of a layer somebody can matter in it, m."""
    walked = length(
        space.track[layer + 1, person, 0] - space.track[layer, person, 0],
        space.track[layer + 1, person, 1] - space.track[layer, person, 1],
    )
    reach = space.body[person, CONTACT_DISTANCE] + space.spread[layer, person, REACH]
    return reach + walked + trip.speed * lattice.durations[layer]


@inlined
def choose_near(trip, layer, x, y, active, step, space):  # type: ignore[no-untyped-def]
    """Write who can matter to a node, as the node sees them; return their number."""
    track, spread, body = space.track, space.spread, space.body
    chosen, near = space.active, space.near
    count = 0
    for i in range(active):
        person = chosen[i]
        from_x, from_y = track[layer, person, 0] - x, track[layer, person, 1] - y
        walk_x = track[layer + 1, person, 0] - track[layer, person, 0]
        walk_y = track[layer + 1, person, 1] - track[layer, person, 1]
        contact, gap = body[person, CONTACT_DISTANCE], spread[layer, person, REACH]
        reach = contact + gap + step + length(walk_x, walk_y)
        if from_x * from_x + from_y * from_y < reach * reach:
            near[count, FROM_X], near[count, FROM_Y] = from_x, from_y
            near[count, WALK_X], near[count, WALK_Y] = walk_x, walk_y
            near[count, CONTACT], near[count, GAP] = contact, gap
            near[count, INVERSE] = spread[layer, person, INVERSE_DEVIATION]
            near[count, SHARE] = body[person, WEIGHT]
            count += 1
    return count


@inlined
def choose_near_discs(x, y, step, obstacles, space):  # type: ignore[no-untyped-def]
    """Write which obstacles a node reaches in one step; return their number."""
    discs, near, count = space.discs, space.near_discs, 0
    for disc in range(obstacles):
        offset_x, offset_y, keep = discs[disc, 0] - x, discs[disc, 1] - y, discs[disc, 2]
        if offset_x * offset_x + offset_y * offset_y < (keep + step) ** 2:
            near[count, 0], near[count, 1], near[count, 2] = offset_x, offset_y, keep
            count += 1
    return count


@inlined
def hits_disc(near_discs, count, move_x, move_y):  # type: ignore[no-untyped-def]
    """Return whether a motion comes too near to an obstacle; one that leaves it may."""
    hit = False
    for i in range(count):
        offset_x, offset_y = near_discs[i, 0], near_discs[i, 1]
        least = swept_distance(offset_x, offset_y, -move_x, -move_y)
        hit |= least < near_discs[i, 2] and least < length(offset_x, offset_y) - 1e-6
    return hit


@inlined
def add_people(  # type: ignore[no-untyped-def]
    near, count, move_x, move_y, costs, layer, contact, intrusion, total, bound
):
    """Return a total with what the people near a motion cost; it may end above the bound."""
    for i in range(count):
        gap = swept_distance(
            near[i, FROM_X], near[i, FROM_Y], near[i, WALK_X] - move_x, near[i, WALK_Y] - move_y
        )
        gap -= near[i, CONTACT]
        if gap < near[i, GAP]:
            cost = cost_of_gap(costs, gap, near[i, INVERSE], layer, contact, intrusion)
            total += near[i, SHARE] * cost
            if total >= bound:
                break
    return total
