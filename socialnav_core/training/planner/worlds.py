"""Worlds of every kind for a planner to learn in."""

import math

import numpy as np

from socialnav_core.config import make_scenario, Scenario

NAMED = ('crowd20', 'hard', 'packed-2.5', 'curriculum-2.5', 'simple')
NAMED_SHARES = (0.5, 0.2, 0.1, 0.05, 0.15)
NON_REACTIVE_SHARE = 0.15
WALLED_SHARE = 0.5


def draw_world(named_share: float, generator: np.random.Generator) -> Scenario:
    """
    Return a named scenario or a random world.

    :param named_share: probability of a named one.
    """
    if generator.random() < named_share:
        return make_scenario(NAMED[generator.choice(len(NAMED), p=NAMED_SHARES)])
    return random_world(generator)


def random_world(generator: np.random.Generator) -> Scenario:
    """Return a world of 0 to 30 people and up to 10 obstacles, in which all numbers vary."""
    people = int(generator.integers(0, 31))
    obstacles = int(generator.integers(0, 11)) * int(generator.random() < 0.6)
    small, large = np.sort(generator.uniform(0.2, 2.0, 2))
    area = 2.5 * people + obstacles * (small + large + 1.4) ** 2 + 16.0
    half_width = float(np.clip(0.5 * math.sqrt(generator.uniform(1.5, 4.0) * area), 4.0, 14.0))
    speed = float(generator.uniform(0.4, 1.4))
    return Scenario(
        'mixed',
        pedestrians=people,
        obstacles=obstacles,
        obstacle_radius_min=float(small),
        obstacle_radius_max=float(large),
        spawn_half_width=half_width,
        minimum_travel=half_width,
        bounds=half_width + 2.5 if generator.random() < WALLED_SHARE else math.inf,
        randomize_attributes=bool(generator.random() < 0.5),
        pedestrian_speed=float(generator.uniform(0.5, 1.6)),
        robot_radius=float(generator.uniform(0.2, 0.5)),
        robot_preferred_speed=speed,
        goal_tolerance=float(generator.uniform(0.15, 0.5)),
        crowd='non_reactive' if generator.random() < NON_REACTIVE_SHARE else 'orca',
        time_limit=15.0 + 3.0 * half_width / speed,
    )
