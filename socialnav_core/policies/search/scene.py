"""Who and what matters in a world, gathered into the memory of the search."""

import numpy as np

from socialnav_core.compilation import inlined
from socialnav_core.policies.search.costs import deviation_used, length, reach_of
from socialnav_core.policies.search.lattice import (
    CONTACT_DISTANCE,
    INVERSE_DEVIATION,
    REACH,
    WEIGHT,
)


@inlined
def gather_people(worlds, world, positions, deviations, weights, lattice, costs, space):  # type: ignore[no-untyped-def]
    """
    Write the predicted people whom the robot can meet, the nearest first; return their number.

    In several modes somebody counts as several people, each with the weight of a mode. The order
    makes sums, and so the choice, independent of the order of the agents.

    :param positions: predicted, m, (batch, modes, layers, agents, 2).
    :param deviations: m, (batch, modes, layers, agents).
    :param weights: of the modes, (batch, modes).
    """
    agents, count = positions.shape[3], 0
    x, y = worlds.position[world, 0], worlds.position[world, 1]
    for mode in range(positions.shape[1]):
        for i in range(agents):
            if worlds.people[world, i] and weights[world, mode] > 0.0:
                space.order[count] = i + agents * mode
                space.gaps[count] = length(
                    worlds.agents[world, i, 0] - x, worlds.agents[world, i, 1] - y
                )
                count += 1
    ranked = np.argsort(space.gaps[:count], kind='mergesort')
    people = space.order[:count][ranked]
    kept = 0
    for index in people:
        mode, agent = index // agents, index % agents
        kept += write_person(
            worlds, world, positions, deviations, weights, lattice, costs, space, mode, agent, kept
        )
    return kept


@inlined
def write_person(  # type: ignore[no-untyped-def]
    worlds, world, positions, deviations, weights, lattice, costs, space, mode, agent, place
):  # fmt: skip
    """Write one person of one mode; return whether the robot can come near to them at all."""
    contact = worlds.radii[world, agent] + worlds.radius[world]
    space.body[place, CONTACT_DISTANCE] = contact
    space.body[place, WEIGHT] = weights[world, mode]
    x, y = worlds.agents[world, agent, 0], worlds.agents[world, agent, 1]
    space.track[0, place, 0], space.track[0, place, 1] = x, y
    driven, can_meet = 0.0, False
    for layer in range(lattice.durations.size):
        to_x = positions[world, mode, layer, agent, 0]
        to_y = positions[world, mode, layer, agent, 1]
        deviation = deviation_used(costs, deviations[world, mode, layer, agent], layer)
        reach = reach_of(costs, deviation)
        space.track[layer + 1, place, 0], space.track[layer + 1, place, 1] = to_x, to_y
        space.spread[layer, place, INVERSE_DEVIATION] = 1.0 / deviation
        space.spread[layer, place, REACH] = reach
        driven += worlds.speed[world] * lattice.durations[layer]
        away = length(x - worlds.position[world, 0], y - worlds.position[world, 1])
        can_meet = can_meet or away < contact + reach + driven + length(to_x - x, to_y - y)
        x, y = to_x, to_y
    return can_meet


@inlined
def gather_obstacles(worlds, world, lattice, costs, space):  # type: ignore[no-untyped-def]
    """Write the obstacles that the robot can reach within the horizon; return their number."""
    count = 0
    driven = worlds.speed[world] * lattice.durations.sum()
    for i in range(worlds.radii.shape[1]):
        if not worlds.obstacles[world, i]:
            continue
        keep = worlds.radii[world, i] + worlds.radius[world] + costs.obstacle_margin
        offset_x = worlds.agents[world, i, 0] - worlds.position[world, 0]
        offset_y = worlds.agents[world, i, 1] - worlds.position[world, 1]
        if offset_x**2 + offset_y**2 < (keep + driven) ** 2:
            space.discs[count, 0] = worlds.agents[world, i, 0]
            space.discs[count, 1] = worlds.agents[world, i, 1]
            space.discs[count, 2] = keep
            count += 1
    return count
