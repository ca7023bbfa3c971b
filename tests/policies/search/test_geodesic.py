"""Laws of the distances around obstacles."""

import math

import numpy as np
import pytest

from socialnav_core.compilation import compiled
from socialnav_core.config import SearchConfig
from socialnav_core.policies.search.fields import (
    distance_at,
    frame_of,
    GeodesicCache,
    NOTHING_IN_THE_WAY,
)
from socialnav_core.policies.search.worlds import worlds_of
from socialnav_core.states import mapped
from tests.policies.search.search_worlds import discs, world

SETTINGS = SearchConfig()


@compiled
def look_up(fields, slot, x, y, goal):
    field = fields.distance[max(0, slot)]
    return distance_at(field, frame_of(fields, slot), x, y, goal[0], goal[1])


def distance(state, x, y):
    """Return the distance to the goal from a point of one world."""
    cache = GeodesicCache(SETTINGS)
    slot = cache.slots_of(worlds_of(state))[0]
    return look_up(cache.fields, slot, x, y, state.robot.goal[0])


def test_without_obstacles_it_is_the_straight_line():
    state = world(discs((2.0, 0.0, 0.3)), goal=(3.0, 4.0))
    assert GeodesicCache(SETTINGS).slots_of(worlds_of(state))[0] == NOTHING_IN_THE_WAY
    assert distance(state, 0.0, 0.0) == pytest.approx(5.0)


def test_where_the_goal_is_in_sight_it_is_the_straight_line():
    state = world(discs((0.0, 3.0, 0.5), static=True), goal=(5.0, 0.0))
    for x, y in ((0.0, 0.0), (-3.0, -2.0), (4.0, 4.0)):
        assert distance(state, x, y) == pytest.approx(math.hypot(5.0 - x, y), abs=0.01)


@pytest.mark.parametrize('radius', [0.5, 1.5, 2.5])
def test_behind_a_disc_it_is_two_tangents_and_an_arc(radius):
    state = world(discs((0.0, 0.0, radius), static=True), start=(-4.0, 0.0), goal=(4.0, 0.0))
    around = radius + 0.3 + 0.03
    exact = 2 * math.sqrt(16.0 - around**2) + around * (math.pi - 2 * math.acos(around / 4.0))
    # cells at the rim of the disc are slow or free as a whole: the way is a little longer
    assert exact * 0.995 < distance(state, -4.0, 0.0) < exact * 1.06


def test_a_gap_narrower_than_the_robot_is_no_way():
    wall = [(0.0, y, 0.5) for y in np.arange(-4.0, 4.1, 1.2)]
    state = world(discs(*wall, static=True), start=(-2.0, 0.0), goal=(2.0, 0.0))
    assert distance(state, -2.0, 0.6) > 8.0


def test_a_goal_inside_an_obstacle_still_draws_near():
    state = world(discs((4.0, 0.0, 1.0), static=True), goal=(4.0, 0.0))
    lengths = [distance(state, x, 0.0) for x in (0.0, 1.0, 2.0)]
    assert np.all(np.diff(lengths) < -0.9)


def test_a_goal_far_beyond_the_window_is_seen_along_the_straight_line():
    state = world(discs((2.0, 3.0, 0.5), static=True), goal=(200.0, 0.0))
    assert distance(state, 0.0, 0.0) == pytest.approx(200.0, abs=0.01)
    behind = world(discs((2.0, 0.0, 1.0), static=True), goal=(200.0, 0.0))
    assert 200.0 < distance(behind, 0.0, 0.0) < 201.0


def test_a_field_is_kept_until_obstacles_or_goal_change():
    cache = GeodesicCache(SETTINGS)
    first = world(discs((2.0, 0.0, 0.5), static=True), goal=(4.0, 0.0))
    second = world(discs((2.0, 0.1, 0.5), static=True), goal=(4.0, 0.0))
    both = mapped(lambda a, b: np.concatenate([a, b]), first, second)
    one, two = cache.slots_of(worlds_of(both))
    assert one != two
    marked = cache.fields.distance
    marked[one, 0, 0] = -7.0  # a field that is computed again loses the mark
    swapped = cache.slots_of(worlds_of(both.select(np.array([1, 0]))))
    assert list(swapped) == [two, one] and marked[one, 0, 0] == -7.0
    moved = both.with_robot(goal=both.robot.goal + 0.01)
    assert not set(cache.slots_of(worlds_of(moved))) & {one, two}


def test_its_memory_does_not_grow_with_the_worlds_that_were_seen():
    cache = GeodesicCache(SETTINGS)
    for x in range(20):
        state = world(discs((x + 2.0, 0.0, 0.5), static=True), start=(x, 0.0), goal=(90.0, 0.0))
        cache.slots_of(worlds_of(state))
    assert len(cache.fields.used) == 2
