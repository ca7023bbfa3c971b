"""What a laser measures that only looks like an obstacle, or like none, over the middleware."""

import math

from helpers.sensing import Sensing
import numpy as np
import pytest


def test_a_hall_without_returns_is_free_where_the_driver_says_so_with_its_longest_range(graph):
    sensing = Sensing(graph, range_max_is='free')
    sensing.changed(ranges=[10.0] * 360)
    assert sensing.answer().agents == []


def test_parts_of_the_robot_are_no_obstacles_where_the_footprint_is_told(graph):
    sensing = Sensing(graph, footprint_radius=0.3)
    posts = [(0.2, 0.2), (0.2, -0.2), (1.5, 0.0)], [0.05, 0.05, 0.3]
    (only,) = sensing.answer(posts).agents
    assert (only.position.x, only.position.y) == pytest.approx((1.5, 0.0), abs=0.05)


def test_in_a_round_room_no_obstacle_covers_the_robot(graph):
    sensing = Sensing(graph)
    sensing.changed(ranges=(1.5 + 0.01 * np.random.default_rng(0).standard_normal(360)).tolist())
    agents = sensing.answer().agents
    gaps = [math.hypot(one.position.x, one.position.y) - one.radius for one in agents]
    assert len(gaps) > 10 and min(gaps) == pytest.approx(1.5, abs=0.05)


def test_a_laser_that_hangs_sees_what_is_on_the_left_on_the_left(graph):
    sensing = Sensing(graph, laser_upside_down=True)
    (only,) = sensing.answer(([(2.0, 1.0)], [0.3])).agents  # as the laser has it
    assert (only.position.x, only.position.y) == pytest.approx((2.0, -1.0), abs=0.05)
