"""Start of an episode: bounded rejection sampling of where everybody is and wants to go."""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import ConfigError, Scenario
from socialnav_core.simulation.births import draw_person, draw_place
from socialnav_core.simulation.random_streams import uniform

ATTEMPTS = 200
RESTARTS = 20000
GAP = 0.2
ANYWHERE = (math.nan, math.nan)
OBSTACLE_GAP = 1.2


class PackingError(ConfigError):
    """A scenario whose agents do not fit into its world."""


def packing_message(scenario: Scenario) -> str:
    """Return what to change about a scenario that could not be laid out."""
    return (
        f'scenario {scenario.name}: no layout found for {scenario.pedestrians} pedestrians and '
        f'{scenario.obstacles} obstacles of radius up to {scenario.obstacle_radius_max:g} m in '
        f'{RESTARTS} tries; lower obstacles, obstacle_radius_max or pedestrians, or raise '
        f'spawn_half_width ({scenario.spawn_half_width:g} m, which must also leave room for '
        f'minimum_travel, {scenario.minimum_travel:g} m)'
    )


class LayoutSettings(NamedTuple):
    """What the compiled sampler takes of a Scenario, in its words and units."""

    pedestrians: int
    circle_crossing: bool
    open_square: bool
    half_width: float
    """Of the square where everybody starts, m."""
    circle_radius: float
    minimum_travel: float
    maximum_travel: float
    start_noise: float
    hardest_obstacles: int
    """So many obstacles have the largest radius."""
    obstacle_radius_min: float
    obstacle_radius_max: float
    randomize_attributes: bool
    pedestrian_radius: float
    pedestrian_speed: float
    robot_radius: float
    robot_start: tuple[float, float]
    """Where the robot begins; nan: anywhere."""
    robot_goal: tuple[float, float]
    """Where it shall arrive; nan: anywhere."""


class Layout(NamedTuple):
    """The start of one world: pedestrians first, then obstacles, who stay where they are."""

    robot: np.ndarray
    """Start and goal of the robot, m, (4,)."""
    position: np.ndarray
    """Centres, m, (agents, 2)."""
    radius: np.ndarray
    """m, (agents,)."""
    speed: np.ndarray
    """Preferred speeds, m/s, (agents,); those of obstacles are not set."""
    goal: np.ndarray
    """m, (agents, 2); an obstacle's is its centre."""


def layout_settings(scenario: Scenario) -> LayoutSettings:
    """Return the settings that the compiled sampler takes."""
    return LayoutSettings(
        pedestrians=scenario.pedestrians,
        circle_crossing=scenario.layout == 'circle_crossing',
        open_square=scenario.layout == 'open_square',
        half_width=scenario.spawn_half_width,
        circle_radius=scenario.circle_radius,
        minimum_travel=scenario.minimum_travel,
        maximum_travel=scenario.maximum_travel,
        start_noise=scenario.start_noise,
        hardest_obstacles=math.ceil(scenario.hardest_obstacle_ratio * scenario.obstacles - 1e-9),
        obstacle_radius_min=scenario.obstacle_radius_min,
        obstacle_radius_max=scenario.obstacle_radius_max,
        randomize_attributes=scenario.randomize_attributes,
        pedestrian_radius=scenario.pedestrian_radius,
        pedestrian_speed=scenario.pedestrian_speed,
        robot_radius=scenario.robot_radius,
        robot_start=scenario.robot_start or ANYWHERE,
        robot_goal=scenario.robot_goal or ANYWHERE,
    )


@compiled
def sample_layout(stream, settings, layout):  # type: ignore[no-untyped-def]
    """Draw a Layout from a random stream, which is advanced; return whether one was found."""
    for _ in range(RESTARTS):
        if not sample_robot(stream, settings, layout.robot):
            continue
        if not sample_obstacles(stream, settings, layout):
            continue
        if settings.open_square:
            if sample_newcomers(stream, settings, layout):
                return True
        elif sample_pedestrians(stream, settings, layout):
            return True
    return False


@compiled
def sample_robot(stream, settings, robot):  # type: ignore[no-untyped-def]
    """Draw the robot's start and goal; return whether they are far enough from each other."""
    if settings.circle_crossing:
        robot[0], robot[1], robot[2], robot[3] = (
            0.0, -settings.circle_radius, 0.0, settings.circle_radius,
        )  # fmt: skip
        place_robot(settings, robot)
        return True
    half_width, noise = settings.half_width, settings.start_noise
    if settings.open_square:
        return sample_anywhere(stream, settings, robot)
    for _ in range(ATTEMPTS):  # about every third draw is accepted
        goal_angle = uniform(stream, 0.0, 2.0 * math.pi)
        start_angle = uniform(stream, 0.0, 2.0 * math.pi)
        robot[0] = half_width * math.cos(start_angle) + uniform(stream, -noise, noise)
        robot[1] = half_width * math.sin(start_angle) + uniform(stream, -noise, noise)
        robot[2] = half_width * math.cos(goal_angle)
        robot[3] = half_width * math.sin(goal_angle)
        if place_robot(settings, robot):
            return True
        travel = max(abs(robot[2] - robot[0]), abs(robot[3] - robot[1]))
        if settings.minimum_travel < travel <= settings.maximum_travel:
            return True
    return False


@compiled
def place_robot(settings, robot):  # type: ignore[no-untyped-def]
    """Put the robot's start and goal where they were chosen; return whether both were."""
    start, goal = settings.robot_start, settings.robot_goal
    has_start, has_goal = not math.isnan(start[0]), not math.isnan(goal[0])
    if has_start:
        robot[0], robot[1] = start
    if has_goal:
        robot[2], robot[3] = goal
    return has_start and has_goal


@compiled
def sample_anywhere(stream, settings, robot):  # type: ignore[no-untyped-def]
    """Draw the robot's start and goal in the square; return whether they are far apart."""
    for _ in range(ATTEMPTS):
        for k in range(4):
            robot[k] = uniform(stream, -settings.half_width, settings.half_width)
        if place_robot(settings, robot):
            return True
        travel = math.sqrt((robot[2] - robot[0]) ** 2 + (robot[3] - robot[1]) ** 2)
        if settings.minimum_travel <= travel <= settings.maximum_travel:
            return True
    return False


@compiled
def sample_newcomers(stream, settings, layout):  # type: ignore[no-untyped-def]
    """Draw pedestrians around the square; return whether all of them found a place."""
    for i in range(settings.pedestrians):
        layout.radius[i], layout.speed[i] = settings.pedestrian_radius, settings.pedestrian_speed
        if settings.randomize_attributes:
            draw_person(stream, layout.speed, layout.radius, i)
        if not draw_place(
            stream, settings.circle_radius, layout.robot, settings.robot_radius, layout.position,
            layout.goal, layout.radius, i, settings.pedestrians, i, layout.radius[i],
        ):  # fmt: skip
            return False
    return True


@compiled
def sample_obstacles(stream, settings, layout):  # type: ignore[no-untyped-def]
    """Draw the obstacles, the largest first; return whether all of them found a place."""
    robot, position, radius = layout.robot, layout.position, layout.radius
    half_width, first = settings.half_width, settings.pedestrians
    for i in range(first, position.shape[0]):
        placed = False
        for _ in range(ATTEMPTS):
            # drawn again with each attempt, so that large ones are accepted less often
            size = settings.obstacle_radius_max
            if i - first >= settings.hardest_obstacles:
                size = uniform(stream, settings.obstacle_radius_min, settings.obstacle_radius_max)
            x = uniform(stream, -half_width, half_width)
            y = uniform(stream, -half_width, half_width)
            if near(x, y, robot[0], robot[1], size + settings.robot_radius + OBSTACLE_GAP):
                continue
            if near(x, y, robot[2], robot[3], size + GAP):
                continue
            if near_any(x, y, size + OBSTACLE_GAP, position, radius, first, i):
                continue
            position[i, 0], position[i, 1], radius[i] = x, y, size
            layout.goal[i, 0], layout.goal[i, 1] = x, y
            placed = True
            break
        if not placed:
            return False
    return True


@compiled
def sample_pedestrians(stream, settings, layout):  # type: ignore[no-untyped-def]
    """Draw the pedestrians, obstacles being there; return whether all of them found a place."""
    radius, speed = layout.radius, layout.speed
    for i in range(settings.pedestrians):
        radius[i], speed[i] = settings.pedestrian_radius, settings.pedestrian_speed
        if settings.randomize_attributes:
            speed[i] = uniform(stream, 0.5, 1.5)
            radius[i] = uniform(stream, 0.3, 0.5)
        placed = False
        for _ in range(ATTEMPTS):
            draw_crossing(stream, settings, speed[i], layout.position[i], layout.goal[i])
            placed = is_apart(
                layout.position, i, layout.robot[0], layout.robot[1], settings, radius
            ) and is_apart(layout.goal, i, layout.robot[2], layout.robot[3], settings, radius)
            if placed:
                break
        if not placed:
            return False
    return True


@compiled
def is_apart(points, i, robot_x, robot_y, settings, radius):  # type: ignore[no-untyped-def]
    """
    Return whether a pedestrian's start or goal is clear of the robot's and of the others'.

    :param points: starts or goals, m, (agents, 2); those of later pedestrians are not there yet.
    :param robot_x: start or goal of the robot, m.
    :param robot_y: m.
    :param radius: of the agents, m, (agents,).
    """
    x, y, gap = points[i, 0], points[i, 1], radius[i] + GAP
    if near(x, y, robot_x, robot_y, gap + settings.robot_radius):
        return False
    if near_any(x, y, gap, points, radius, 0, i):
        return False
    return not near_any(x, y, gap, points, radius, settings.pedestrians, points.shape[0])


@compiled
def draw_crossing(stream, settings, speed, start, goal):  # type: ignore[no-untyped-def]
    """
    Draw the start and goal of one pedestrian.

    :param speed: preferred speed, m/s; noise on the circle is proportional to it.
    :param start: written, m, (2,).
    :param goal: written, m, (2,).
    """
    if settings.circle_crossing:
        angle = uniform(stream, 0.0, 2.0 * math.pi)
        start[0] = settings.circle_radius * math.cos(angle) + uniform(stream, -0.5, 0.5) * speed
        start[1] = settings.circle_radius * math.sin(angle) + uniform(stream, -0.5, 0.5) * speed
        goal[0], goal[1] = -start[0], -start[1]
        return
    half_width = settings.half_width
    side = -1.0 if uniform(stream, 0.0, 1.0) < 0.5 else 1.0
    start[0] = side * uniform(stream, 0.0, half_width)
    start[1] = uniform(stream, -half_width, half_width)
    goal[0] = -side * uniform(stream, 0.0, half_width)
    goal[1] = uniform(stream, -half_width, half_width)


@compiled
def near(x, y, other_x, other_y, distance):  # type: ignore[no-untyped-def]
    """Return whether two points are closer than a distance, m."""
    return (x - other_x) ** 2 + (y - other_y) ** 2 < distance * distance


@compiled
def near_any(x, y, gap, centre, radius, begin, end):  # type: ignore[no-untyped-def]
    """
    Return whether a point is closer to a disc than a gap, m, from its rim.

    :param begin: first disc that counts.
    :param end: the one after the last.
    """
    for j in range(begin, end):  # noqa: SIM110, compiled faster than any()
        if near(x, y, centre[j, 0], centre[j, 1], gap + radius[j]):
            return True
    return False
