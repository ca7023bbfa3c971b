"""Laws of the distances to goals where people stand in the way."""

import math

import numpy as np
import pytest

from socialnav_core.config import SearchConfig
from socialnav_core.policies import SearchPolicy
from socialnav_core.policies.search.candidates import ways_on
from socialnav_core.policies.search.crowding import Crowding
from socialnav_core.policies.search.fields import GeodesicCache
from socialnav_core.policies.search.worlds import worlds_of
from socialnav_core.prediction.constant_velocity import ConstantVelocity
from tests.policies.search.search_worlds import discs, distance_to_goal, drive, gaps, world

HORIZON = 3.0
SETTINGS = SearchConfig(crowding=3.0)
WAYS_ROUND = discs((2.5, 1.3, 0.7), (2.5, -2.2, 0.7), static=True)
"""Two obstacles: the straight way leads between them."""


def distances(state, points=None, settings=SETTINGS, deviation=0.03):
    """Return the distances to the goal of one world from some points, by default the robot."""
    worlds, cache = worlds_of(state), GeodesicCache(settings)
    predictor = ConstantVelocity(standing_deviation=deviation)
    prediction = predictor.predict(state, np.array([HORIZON]))
    slots = cache.slots_of(worlds)
    fields, slots = Crowding(settings).add(worlds, prediction, HORIZON, cache.fields, slots)
    points = state.robot.position[None] if points is None else np.array([points], float)
    found, subgoals = np.zeros(points.shape[:2]), np.zeros(points.shape)
    ways_on(worlds, slots, fields, points, found, subgoals)
    return found[0]


def row(velocity=(0.0, 0.0)):
    """Return people side by side across the way, and the obstacles."""
    people = discs((2.5, 0.2, 0.3), (2.5, -0.5, 0.3), (2.5, -1.1, 0.3), velocity=[velocity] * 3)
    return people.append(WAYS_ROUND)


def test_people_who_stand_make_the_way_longer_but_do_not_close_it():
    free, crowded = distances(world(WAYS_ROUND)), distances(world(row()))
    assert free + 0.3 < crowded < free + SETTINGS.crowding * 2 * (0.3 + 0.3)


def test_the_way_gets_longer_without_obstacles_as_well():
    people = discs((2.5, 0.0, 0.3), (2.5, 1.0, 0.3), (2.5, -1.0, 0.3))
    assert distances(world(people)) > 5.0 + 0.3


def test_people_who_walk_change_nothing():
    assert distances(world(row((0.0, 1.0)))) == distances(world(WAYS_ROUND))


def test_who_may_have_gone_by_then_counts_for_less():
    sure, unsure = distances(world(row())), distances(world(row()), deviation=0.6)
    assert distances(world(WAYS_ROUND)) < unsure < sure


def test_from_beyond_the_people_nothing_changes():
    points = [(3.5, 0.0), (4.5, 1.0), (5.5, -2.0)]
    crowded, free = distances(world(row()), points), distances(world(WAYS_ROUND), points)
    assert np.allclose(crowded, free, atol=0.05)


def test_no_crowding_leaves_people_aside():
    settings = SearchConfig(crowding=0.0)
    assert distances(world(row()), settings=settings) == distances(world(WAYS_ROUND))


def test_the_order_of_people_changes_no_bit():
    turn = np.linspace(0.0, 2.0 * math.pi, 17)
    places = np.stack([2.5 + np.cos(turn), np.sin(turn), np.full(17, 0.3)], axis=-1)
    points = np.random.default_rng(0).uniform(-2.0, 6.0, (50, 2))
    one = distances(world(discs(*places)), points)
    assert np.array_equal(one, distances(world(discs(*places[::-1])), points))


def test_a_world_is_found_again_whatever_row_it_has():
    settings, policy = SETTINGS, SearchPolicy(SETTINGS)
    one, other = world(row()), world(row(), goal=(0.0, 5.0))
    first = [policy.act(state) for state in (one, other, one)]
    assert np.array_equal(first[0], first[2])
    assert np.array_equal(first[1], SearchPolicy(settings).act(other))


@pytest.mark.parametrize('crowding, arrives', [(3.0, True), (0.0, False)])
def test_people_who_close_the_short_way_send_it_round(crowding, arrives):
    wall = discs(*((2.5, y, 0.3) for y in np.arange(-0.9, 5.1, 0.7)))
    policy = SearchPolicy(SearchConfig(crowding=crowding))
    states = drive(policy, world(wall, start=(0.0, 1.0), goal=(5.0, 1.0)), steps=80)
    assert (distance_to_goal(states[-1]) < 0.3) == arrives
    assert min(gaps(state).min() for state in states) > 0.0
