"""Ways to the goal around the obstacles, as the value network at the horizon sees them."""

import numpy as np

from socialnav_core.policies.search.candidates import ways_on
from socialnav_core.policies.search.fields import GeodesicCache
from socialnav_core.policies.search.worlds import worlds_of
from socialnav_core.states import CrowdState


def ways_from(
    geodesics: GeodesicCache, state: CrowdState, positions: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return distances to the goals around the obstacles, and goals in sight at that distance.

    :param positions: from where, m, (batch, positions, 2).
    :returns: m, (batch, positions), and m, (batch, positions, 2).
    """
    worlds = worlds_of(state)
    distances, subgoals = np.zeros(positions.shape[:2]), np.zeros(positions.shape)
    slots = geodesics.slots_of(worlds)
    ways_on(worlds, slots, geodesics.fields, positions, distances, subgoals)
    return distances, subgoals
