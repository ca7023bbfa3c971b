"""Laws of the schedules."""

import itertools

import pytest

from socialnav_core.config import TrainingConfig
from socialnav_core.training.schedules import epsilon, learning_rate

CONFIG = TrainingConfig(iterations=100)


def test_learning_rate_is_constant_up_to_the_start_of_the_decay():
    assert {learning_rate(CONFIG, iteration) for iteration in range(31)} == {1e-3}


def test_learning_rate_ends_at_its_final_value():
    assert learning_rate(CONFIG, 99) == pytest.approx(1e-4)


def test_learning_rate_falls_by_the_same_factor_each_iteration():
    rates = [learning_rate(CONFIG, iteration) for iteration in range(30, 100)]
    factors = [later / earlier for earlier, later in itertools.pairwise(rates)]
    assert factors == pytest.approx([factors[0]] * 69) and factors[0] < 1


def test_epsilon_falls_linearly_over_the_first_half():
    assert epsilon(CONFIG, 0) == pytest.approx(0.3)
    assert epsilon(CONFIG, 25) == pytest.approx(0.175)
    assert epsilon(CONFIG, 50) == epsilon(CONFIG, 99) == pytest.approx(0.05)


def test_schedules_follow_the_episodes_where_they_are_the_length():
    config = TrainingConfig(iterations=3, episodes=5000, epsilon_share=0.8)
    assert epsilon(config, 2000) == pytest.approx(0.175)
    assert epsilon(config, 3999) > epsilon(config, 4000) == epsilon(config, 5000)
    assert learning_rate(config, 1500) == 1e-3 > learning_rate(config, 1600)
