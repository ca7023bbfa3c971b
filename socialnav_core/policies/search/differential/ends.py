"""How candidates of the search for a differential drive begin and end."""

from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled, inlined
from socialnav_core.policies.search.differential.lattice import HEADING, SPEED, TURN_RATE
from socialnav_core.policies.search.differential.remaining import (
    angle_between,
    driving_time,
    turning_time,
)
from socialnav_core.policies.search.fields import frame_of, way_down
from socialnav_core.policies.search.search import ARRIVAL_SHARE, LEAST_REMAINING


class Ends(NamedTuple):
    """First commands and last motions of candidates; see `Candidates`."""

    commands: np.ndarray  # speed, m/s, and turn rate, rad/s, (batch, candidates, 2)
    headings: np.ndarray  # at the horizon, rad, (batch, candidates)
    speeds: np.ndarray  # there, m/s, (batch, candidates)


def make_ends(batch: int, count: int) -> Ends:
    """Return memory for a number of candidates in each world."""
    return Ends(np.zeros((batch, count, 2)), np.zeros((batch, count)), np.zeros((batch, count)))


@inlined
def write_ends(world, space, candidates, ends):  # type: ignore[no-untyped-def]
    """Write how the candidates of a world, which were written just now, begin and end."""
    last = space.nodes.shape[0] - 1
    for place in range(candidates.firsts.size):
        if candidates.totals[world, place] == np.inf:
            break
        first = space.nodes[1, candidates.firsts[place]]
        ends.commands[world, place, 0] = first[SPEED]
        ends.commands[world, place, 1] = first[TURN_RATE]
        end = space.nodes[last, candidates.lasts[place]]
        ends.headings[world, place], ends.speeds[world, place] = end[HEADING], end[SPEED]


@compiled
def write_time_left(worlds, present, base, slots, fields, lattice, costs, times):  # type: ignore[no-untyped-def]
    """
    Write the time that the search reckons for the way to each goal, s, (batch,).

    :param present: headings, speeds and turn rates, (batch, 3).
    """
    for world in range(times.size):
        field, frame = fields.distance[max(0, slots[world])], frame_of(fields, slots[world])
        down_x, down_y, distance = way_down(
            field, frame, worlds.position[world, 0], worlds.position[world, 1],
            worlds.goal[world, 0], worlds.goal[world, 1],
        )  # fmt: skip
        left = max(distance - ARRIVAL_SHARE * costs.goal_tolerance, LEAST_REMAINING)
        heading, speed, turn_rate = present[world]
        error = angle_between(np.cos(heading), np.sin(heading), down_x, down_y)
        preferred = worlds.speed[world]
        times[world] = driving_time(base, preferred, left, speed)
        times[world] += lattice.turn_loss * turning_time(
            base, preferred, lattice.arc_share, left, error, turn_rate
        )
