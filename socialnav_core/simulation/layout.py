"""Start of an episode: bounded rejection sampling of where everybody is and wants to go."""

import math
from typing import Any

from socialnav_core.compilation import compiled
from socialnav_core.config import ConfigError, Scenario
from socialnav_core.simulation.random_streams import uniform

ATTEMPTS = 200
RESTARTS = 20000
GAP = 0.2
OBSTACLE_GAP = 1.2


class PackingError(ConfigError):
    """A scenario whose agents do not fit into its world."""


def packing_message(scenario: Scenario) -> str:
    """
    Return what to change about a scenario that could not be laid out.

    :param scenario: the scenario.
    """
    return (
        f'scenario {scenario.name}: no layout found for {scenario.pedestrians} pedestrians and '
        f'{scenario.obstacles} obstacles of radius up to {scenario.obstacle_radius_max:g} m in '
        f'{RESTARTS} tries; lower obstacles, obstacle_radius_max or pedestrians, or raise '
        f'spawn_half_width ({scenario.spawn_half_width:g} m, which must also leave room for '
        f'minimum_travel, {scenario.minimum_travel:g} m)'
    )


def layout_settings(scenario: Scenario) -> tuple[Any, ...]:
    """
    Return the settings that the compiled sampler takes.

    :param scenario: the scenario.
    """
    hardest = math.ceil(scenario.hardest_obstacle_ratio * scenario.obstacles - 1e-9)
    return (
        scenario.layout == 'circle_crossing', scenario.spawn_half_width, scenario.circle_radius,
        scenario.minimum_travel, scenario.start_noise, hardest, scenario.obstacle_radius_min,
        scenario.obstacle_radius_max, scenario.randomize_attributes, scenario.pedestrian_radius,
        scenario.pedestrian_speed, scenario.robot_radius,
    )  # fmt: skip


@compiled
def sample_layout(stream, pedestrians, settings, robot, position, radius, speed, goal):  # type: ignore[no-untyped-def]
    """
    Draw the start of one episode; return whether a layout was found.

    :param stream: random stream of the layout, advanced.
    :param pedestrians: number of pedestrians; the other agents are obstacles.
    :param settings: of layout_settings.
    :param robot: out, (4,): start and goal of the robot, m.
    :param position: out, (agents, 2): centres, m.
    :param radius: out, (agents,), m.
    :param speed: out, (pedestrians,): preferred speeds, m/s.
    :param goal: out, (agents, 2): goals, m; an obstacle's is its centre.
    """
    for _ in range(RESTARTS):
        if not sample_robot(stream, settings, robot):
            continue
        if not sample_obstacles(stream, pedestrians, settings, robot, position, radius, goal):
            continue
        if sample_pedestrians(stream, pedestrians, settings, robot, position, radius, speed, goal):
            return True
    return False


@compiled
def sample_robot(stream, settings, robot):  # type: ignore[no-untyped-def]
    """
    Draw the robot's start and goal; return whether they are far enough from each other.

    :param stream: random stream, advanced.
    :param settings: of layout_settings.
    :param robot: out, (4,), m.
    """
    circle, half_width, circle_radius, minimum_travel, noise = settings[:5]
    if circle:
        robot[0], robot[1], robot[2], robot[3] = 0.0, -circle_radius, 0.0, circle_radius
        return True
    for _ in range(ATTEMPTS):  # about every third draw is accepted
        goal_angle = uniform(stream, 0.0, 2.0 * math.pi)
        start_angle = uniform(stream, 0.0, 2.0 * math.pi)
        robot[0] = half_width * math.cos(start_angle) + uniform(stream, -noise, noise)
        robot[1] = half_width * math.sin(start_angle) + uniform(stream, -noise, noise)
        robot[2] = half_width * math.cos(goal_angle)
        robot[3] = half_width * math.sin(goal_angle)
        travel = max(abs(robot[2] - robot[0]), abs(robot[3] - robot[1]))
        if travel > minimum_travel:
            return True
    return False


@compiled
def sample_obstacles(stream, pedestrians, settings, robot, position, radius, goal):  # type: ignore[no-untyped-def]
    """
    Draw the obstacles, the largest first; return whether all of them found a place.

    A radius is drawn again with each attempt, so that large ones are accepted less often.

    :param stream: random stream, advanced.
    :param pedestrians: number of pedestrians, whose slots come first.
    :param settings: of layout_settings.
    :param robot: (4,), start and goal of the robot, m.
    :param position: out, (agents, 2), m.
    :param radius: out, (agents,), m.
    :param goal: out, (agents, 2), m.
    """
    half_width, hardest, low, high, robot_radius = (
        settings[1], settings[5], settings[6], settings[7], settings[11],
    )  # fmt: skip
    for i in range(pedestrians, position.shape[0]):
        placed = False
        for _ in range(ATTEMPTS):
            size = high if i - pedestrians < hardest else uniform(stream, low, high)
            x = uniform(stream, -half_width, half_width)
            y = uniform(stream, -half_width, half_width)
            if near(x, y, robot[0], robot[1], size + robot_radius + OBSTACLE_GAP):
                continue
            if near(x, y, robot[2], robot[3], size + GAP):
                continue
            if near_any(x, y, size + OBSTACLE_GAP, position, radius, pedestrians, i):
                continue
            position[i, 0], position[i, 1], radius[i] = x, y, size
            goal[i, 0], goal[i, 1] = x, y
            placed = True
            break
        if not placed:
            return False
    return True


@compiled
def sample_pedestrians(stream, pedestrians, settings, robot, position, radius, speed, goal):  # type: ignore[no-untyped-def]
    """
    Draw the pedestrians one after another; return whether all of them found a place.

    :param stream: random stream, advanced.
    :param pedestrians: number of pedestrians.
    :param settings: of layout_settings.
    :param robot: (4,), start and goal of the robot, m.
    :param position: in and out, (agents, 2), obstacles are there already, m.
    :param radius: in and out, (agents,), m.
    :param speed: out, (pedestrians,), m/s.
    :param goal: in and out, (agents, 2), m.
    """
    agents = position.shape[0]
    for i in range(pedestrians):
        radius[i], speed[i] = settings[9], settings[10]
        if settings[8]:
            speed[i] = uniform(stream, 0.5, 1.5)
            radius[i] = uniform(stream, 0.3, 0.5)
        placed = False
        for _ in range(ATTEMPTS):
            draw_crossing(stream, settings, speed[i], position[i], goal[i])
            x, y = position[i]
            gap = radius[i] + GAP
            if near(x, y, robot[0], robot[1], gap + settings[11]):
                continue
            if near_any(x, y, gap, position, radius, 0, i):
                continue
            if near_any(x, y, gap, position, radius, pedestrians, agents):
                continue
            x, y = goal[i]
            if near(x, y, robot[2], robot[3], gap + settings[11]):
                continue
            if near_any(x, y, gap, goal, radius, 0, i):
                continue
            if near_any(x, y, gap, goal, radius, pedestrians, agents):
                continue
            placed = True
            break
        if not placed:
            return False
    return True


@compiled
def draw_crossing(stream, settings, speed, start, goal):  # type: ignore[no-untyped-def]
    """
    Draw the start and goal of one pedestrian.

    :param stream: random stream, advanced.
    :param settings: of layout_settings.
    :param speed: preferred speed, m/s; noise on the circle is proportional to it.
    :param start: out, (2,), m.
    :param goal: out, (2,), m.
    """
    circle, half_width, circle_radius = settings[:3]
    if circle:
        angle = uniform(stream, 0.0, 2.0 * math.pi)
        start[0] = circle_radius * math.cos(angle) + uniform(stream, -0.5, 0.5) * speed
        start[1] = circle_radius * math.sin(angle) + uniform(stream, -0.5, 0.5) * speed
        goal[0], goal[1] = -start[0], -start[1]
        return
    side = -1.0 if uniform(stream, 0.0, 1.0) < 0.5 else 1.0
    start[0] = side * uniform(stream, 0.0, half_width)
    start[1] = uniform(stream, -half_width, half_width)
    goal[0] = -side * uniform(stream, 0.0, half_width)
    goal[1] = uniform(stream, -half_width, half_width)


@compiled
def renew_goal(stream, half_width, i, pedestrians, position, radius, goal):  # type: ignore[no-untyped-def]
    """
    Draw another goal for a pedestrian, free of obstacles; return whether one was found.

    :param stream: random stream of the pedestrian, advanced.
    :param half_width: radius of the circle of goals, m.
    :param i: the pedestrian.
    :param pedestrians: number of pedestrians.
    :param position: (agents, 2), m.
    :param radius: (agents,), m.
    :param goal: out, (agents, 2), m.
    """
    for _ in range(ATTEMPTS):
        angle = uniform(stream, 0.0, 2.0 * math.pi)
        x, y = half_width * math.cos(angle), half_width * math.sin(angle)
        gap = radius[i] + GAP
        if not near_any(x, y, gap, position, radius, pedestrians, position.shape[0]):
            goal[i, 0], goal[i, 1] = x, y
            return True
    return False


@compiled
def near(x, y, other_x, other_y, distance):  # type: ignore[no-untyped-def]
    """
    Return whether two points are closer than a distance.

    :param x: first point, m.
    :param y: first point, m.
    :param other_x: second point, m.
    :param other_y: second point, m.
    :param distance: m.
    """
    return (x - other_x) ** 2 + (y - other_y) ** 2 < distance * distance


@compiled
def near_any(x, y, gap, centre, radius, begin, end):  # type: ignore[no-untyped-def]
    """
    Return whether a point is closer to a disc of a range than a gap from its rim.

    :param x: the point, m.
    :param y: the point, m.
    :param gap: m.
    :param centre: (agents, 2), m.
    :param radius: (agents,), m.
    :param begin: first disc.
    :param end: the one after the last.
    """
    for j in range(begin, end):  # noqa: SIM110, compiled faster than any()
        if near(x, y, centre[j, 0], centre[j, 1], gap + radius[j]):
            return True
    return False
