"""Laws of what being near to people costs."""

import math

import pytest

from socialnav_core.compilation import compiled
from socialnav_core.config import SearchConfig
from socialnav_core.policies.search.costs import (
    cost_of_gap,
    costs_when_slow,
    normal_distribution,
)
from socialnav_core.policies.search.search_policy import costs_of

COSTS = costs_of(SearchConfig())


@compiled
def probability(z):
    return normal_distribution(z)


@compiled
def cost(costs, gap, deviation, layer):
    return cost_of_gap(costs, gap, 1.0 / deviation, layer, costs.contact, costs.intrusion)


@compiled
def at_speed(costs, speed, usual_speed):
    return costs_when_slow(costs, speed, usual_speed)


@pytest.mark.parametrize('z', [-9.0, -2.0, -0.3, 0.0, 0.7, 3.1, 9.0])
def test_the_table_is_the_normal_distribution(z):
    assert probability(z) == pytest.approx(0.5 * math.erfc(-z / math.sqrt(2.0)), abs=5e-5)


@pytest.mark.parametrize('layer', [0, 3])
@pytest.mark.parametrize('deviation', [0.05, 0.5])
def test_nearer_is_never_cheaper(layer, deviation):
    costs = [cost(COSTS, 0.05 * k - 0.5, deviation, layer) for k in range(40)]
    assert all(near >= far for near, far in zip(costs, costs[1:], strict=False))
    assert costs[0] > costs[-1]


def test_a_collision_in_the_first_layer_costs_more_than_any_detour():
    assert cost(COSTS, -0.01, 1.0, 0) > 20.0 > 10 * cost(COSTS, -0.01, 1.0, 1)


@pytest.mark.parametrize('speed', [1.0, 1.5])
def test_a_robot_of_the_usual_speed_has_the_costs_of_the_settings(speed):
    assert at_speed(COSTS, speed, 1.0) == COSTS


def test_a_robot_of_half_the_usual_speed_counts_people_twice():
    slow = at_speed(COSTS, 0.5, 1.0)
    assert slow.contact == 2.0 * COSTS.contact
    assert slow.intrusion == 2.0 * COSTS.intrusion
    assert slow.slack == 2.0 * COSTS.slack


def test_a_slow_robot_discounts_with_the_way_that_it_gets():
    slow = at_speed(COSTS, 0.5, 1.0)
    assert slow.contact_discount**2 == pytest.approx(COSTS.contact_discount)
    assert slow.intrusion_discount**2 == pytest.approx(COSTS.intrusion_discount)
