"""What being near to people costs, in seconds of travel."""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import inlined

TABLE_END = 4.0
"""The normal distribution is tabulated up to this number of standard deviations."""
TABLE_CELLS = 1024
PLACES = np.linspace(-TABLE_END, TABLE_END, TABLE_CELLS + 1)
TABLE = np.array([0.5 * math.erfc(-place / math.sqrt(2.0)) for place in PLACES])
NEAR_DEVIATIONS = 2.5
"""Farther away than this number of standard deviations people cost nothing."""
TOUCH = 0.02
"""In the first layer a gap below this is a collision, whatever the deviation, m."""
COLLISION = 20.0
"""Cost of a collision in the first layer, s: more than any detour."""
DEPTH = 100.0
"""Cost of each metre that it is deeper, s/m: who overlaps already must get away."""


class Costs(NamedTuple):
    """Settings of the costs; SearchConfig says what they are."""

    contact: float
    contact_discount: float
    intrusion: float
    intrusion_discount: float
    comfort_distance: float
    turning: float
    obstacle_margin: float
    slack: float
    goal_tolerance: float
    deviation_near: float
    deviation_decay: float
    deviation_share: float
    deviation_floor: float
    deviation_limit: float


@inlined
def length(x, y):  # type: ignore[no-untyped-def]
    """Return the length of a vector; math.hypot guards against overflow and is slow."""
    return math.sqrt(x * x + y * y)


@inlined
def costs_when_slow(costs, speed, usual_speed):  # type: ignore[no-untyped-def]
    """
    Return the costs for a robot that may be slower than usual.

    It needs longer for the same way round somebody, so people and the slack count as many times
    more, and what is ahead is discounted with the way that it gets, not with the time.
    """
    share = min(1.0, speed / usual_speed)
    return Costs(
        costs.contact / share, costs.contact_discount**share, costs.intrusion / share,
        costs.intrusion_discount**share, costs.comfort_distance, costs.turning,
        costs.obstacle_margin, costs.slack / share, costs.goal_tolerance, costs.deviation_near,
        costs.deviation_decay, costs.deviation_share, costs.deviation_floor,
        costs.deviation_limit,
    )  # fmt: skip


@inlined
def normal_distribution(z):  # type: ignore[no-untyped-def]
    """Return the probability that a standard normal variable is below z, from the table."""
    place = (z + TABLE_END) * (TABLE_CELLS / (2.0 * TABLE_END))
    if place <= 0.0:
        return 0.0
    if place >= TABLE_CELLS:
        return 1.0
    cell = int(place)
    return TABLE[cell] + (place - cell) * (TABLE[cell + 1] - TABLE[cell])


@inlined
def deviation_used(costs, predicted, layer):  # type: ignore[no-untyped-def]
    """
    Return the standard deviation that the search counts with, m.

    Later risks are discounted. Where a risk is so large that the discount of one layer exceeds
    the layer's duration, waiting once more always seems better: that is why it is limited.
    """
    share = costs.deviation_share
    share += (costs.deviation_near - share) * costs.deviation_decay**layer
    wanted = predicted * share + costs.deviation_floor
    return max(min(wanted, costs.deviation_limit), 1e-6)


@inlined
def reach_of(costs, deviation):  # type: ignore[no-untyped-def]
    """Return the gap beyond which somebody costs nothing, m."""
    return max(costs.comfort_distance + 2.0 * deviation, NEAR_DEVIATIONS * deviation)


@inlined
def cost_of_gap(costs, gap, inverse_deviation, layer, contact, intrusion):  # type: ignore[no-untyped-def]
    """
    Return what a least gap to somebody during a layer costs, s.

    :param inverse_deviation: of the predicted position, 1/m.
    :param contact: cost of a certain contact in this layer, s.
    :param intrusion: cost of certain discomfort in this layer, s.
    """
    cost = intrusion * normal_distribution((costs.comfort_distance - gap) * inverse_deviation)
    if layer == 0 and gap < TOUCH:
        return cost + COLLISION + DEPTH * (TOUCH - gap)
    return cost + contact * normal_distribution(-gap * inverse_deviation)
