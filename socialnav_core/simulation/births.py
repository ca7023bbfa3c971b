"""People who come from all around an open square, in the world of `crowd20_random`."""

import math

from socialnav_core.compilation import compiled
from socialnav_core.simulation.random_streams import uniform

ATTEMPTS = 200
GAP = 0.25
"""Least gap between a new place and everybody and their goals, m."""
OFFSET = 2.0
"""Places are moved off the circle by up to this along each axis, m; to one side only, as there."""
GOAL_NOISE = 0.5
"""A later goal is moved off the circle by up to this times the preferred speed, s."""
SPEEDS, RADII = (0.5, 1.5), (0.3, 0.5)


@compiled
def draw_person(stream, speed, radius, i):  # type: ignore[no-untyped-def]
    """Draw the preferred speed, m/s, and the radius, m, of a new person."""
    speed[i] = uniform(stream, SPEEDS[0], SPEEDS[1])
    radius[i] = uniform(stream, RADII[0], RADII[1])


@compiled
def draw_place(  # type: ignore[no-untyped-def]
    stream, circle, robot, robot_radius, position, goal, radius, count, people, i, size
):
    """
    Draw where a person of a size comes from, and the goal opposite; return whether there is room.

    :param circle: radius of the circle that people come from, m.
    :param robot: position and goal of the robot, m, (4,).
    :param position: of people, m, (agents, 2); that of person i is written.
    :param goal: m, (agents, 2); that of person i is written.
    :param radius: m, (agents,).
    :param count: the first so many people are there and kept clear of, and so are obstacles.
    :param people: number of people; obstacles come behind them.
    """
    for _ in range(ATTEMPTS):
        angle = uniform(stream, 0.0, 2.0 * math.pi)
        x = circle * math.cos(angle) + uniform(stream, 0.0, OFFSET)
        y = circle * math.sin(angle) + uniform(stream, 0.0, OFFSET)
        if is_free(x, y, robot, robot_radius, position, goal, radius, count, people, -1, size):
            position[i, 0], position[i, 1], goal[i, 0], goal[i, 1] = x, y, -x, -y
            return True
    return False


@compiled
def draw_other_goal(  # type: ignore[no-untyped-def]
    stream, circle, robot, robot_radius, position, goal, radius, people, i, speed
):
    """Draw another goal for person i; return whether there is room. See `draw_place`."""
    for _ in range(ATTEMPTS):
        angle = uniform(stream, 0.0, 2.0 * math.pi)
        x = circle * math.cos(angle) + speed * uniform(stream, -GOAL_NOISE, GOAL_NOISE)
        y = circle * math.sin(angle) + speed * uniform(stream, -GOAL_NOISE, GOAL_NOISE)
        if is_free(
            x, y, robot, robot_radius, position, goal, radius, people, people, i, radius[i]
        ):
            goal[i, 0], goal[i, 1] = x, y
            return True
    return False


@compiled
def is_free(x, y, robot, robot_radius, position, goal, radius, count, people, but, size):  # type: ignore[no-untyped-def]
    """
    Return whether a place is clear of the robot, of people, of all their goals and of obstacles.

    :param but: person who does not count, -1 for none.
    """
    keep = (size + robot_radius + GAP) ** 2
    if (x - robot[0]) ** 2 + (y - robot[1]) ** 2 < keep:
        return False
    if (x - robot[2]) ** 2 + (y - robot[3]) ** 2 < keep:
        return False
    for j in range(radius.size):
        if j == but or count <= j < people:
            continue
        keep = (size + radius[j] + GAP) ** 2
        if (x - position[j, 0]) ** 2 + (y - position[j, 1]) ** 2 < keep:
            return False
        if (x - goal[j, 0]) ** 2 + (y - goal[j, 1]) ** 2 < keep:
            return False
    return True
