"""How fast each case can be solved at all, by a robot that knows what everybody will do."""

import dataclasses
import math

import numpy as np

from socialnav_core.config import BoundConfig, Scenario
from socialnav_core.evaluation.bound_kernel import fastest_path, NO_ROOM, TOUCH, Trip, UNSOLVED
from socialnav_core.evaluation.futures import Futures
from socialnav_core.metrics.table import finite_or_none
from socialnav_core.simulation.kinematics.angles import direction
from socialnav_core.tables import number

WIDEST_CELL = 0.5
"""Cells are at most this part of a step wide, so that a slow robot gets from one to another."""
ROOM = 2**18
GREATEST_ROOM = 2**24
"""Positions that there is memory for at first, and at most (0.8 GB)."""


@dataclasses.dataclass(frozen=True)
class Bounds:
    """The times of some cases, s, (cases,); inf where no path was found in time."""

    fastest: np.ndarray
    """Of the fastest path free of collisions."""
    comfortable: np.ndarray
    """Of the fastest path that also keeps the comfort distance to people throughout."""


def bounds_of(futures: Futures, config: BoundConfig) -> Bounds:
    """Return the bounds of some cases."""
    cases = range(len(futures.position))
    times = [
        [path_time(find_path(futures, case, gap, config), futures.scenario) for case in cases]
        for gap in (0.0, config.comfort_distance)
    ]
    return Bounds(*(np.array(column) for column in times))


def path_time(path: np.ndarray | None, scenario: Scenario) -> float:
    """Return how long a path takes, s, inf for None."""
    return math.inf if path is None else (len(path) - 1) * scenario.time_step


def find_path(
    futures: Futures, case: int, gap: float, config: BoundConfig | None = None
) -> np.ndarray | None:
    """
    Return the positions of the fastest path of a case, m, (steps + 1, 2), or None.

    The robot has no inertia. The path is a witness: a robot that follows it in the simulator
    arrives with its last step.

    :param case: row of the case in the futures.
    :param gap: to people that is kept throughout, m; obstacles and walls may be grazed.
    """
    config = config or BoundConfig()
    agents, robot = futures.start.agents, futures.start.robot
    gaps = np.where(agents.static[case], 0.0, gap) + robot.radius[case] + TOUCH
    keep = agents.radius[case] + gaps
    trip = trip_of(futures, case, config)
    moves = trip.stride * moves_of(config)
    path = np.empty((futures.position.shape[1] + 1, 2))
    room = ROOM
    while True:
        steps = fastest_path(
            trip, futures.position[case], futures.velocity[case], keep, moves, room, path
        )
        if steps != NO_ROOM:
            return None if steps == UNSOLVED else path[: steps + 1]
        if room < GREATEST_ROOM:
            room *= 4
        else:  # a path through wider cells is a witness too
            trip = trip._replace(cell=2.0 * trip.cell)


def trip_of(futures: Futures, case: int, config: BoundConfig) -> Trip:
    """Return what a case asks of the robot."""
    robot, scenario = futures.start.robot, futures.scenario
    stride = float(robot.preferred_speed[case]) * scenario.time_step
    start, goal = robot.position[case].tolist(), robot.goal[case].tolist()
    return Trip(
        start_x=start[0],
        start_y=start[1],
        goal_x=goal[0],
        goal_y=goal[1],
        tolerance=scenario.goal_tolerance - TOUCH,
        stride=stride,
        limit=float(futures.start.bounds[case] - robot.radius[case]) - TOUCH,
        duration=scenario.time_step,
        cell=min(config.cell, WIDEST_CELL * stride),
    )


def moves_of(config: BoundConfig) -> np.ndarray:
    """Return the ways of a step in units of its stride: full, half and none, (moves, 2)."""
    angles = np.arange(config.headings) * (2.0 * math.pi / config.headings)
    ahead = direction(angles)
    return np.concatenate([ahead, 0.5 * ahead, np.zeros((1, 2))])


def bounds_table(bounds: Bounds, comfort_distance: float) -> list[tuple[str, ...]]:
    """Return the names of the columns and a row for each kind of path."""
    kinds = ('free of collisions', f'keeping {comfort_distance:g} m of people')
    rows: list[tuple[str, ...]] = [('fastest path', 'cases solved', 'mean time of these')]
    for kind, times in zip(kinds, (bounds.fastest, bounds.comfortable), strict=True):
        solved = times[np.isfinite(times)]
        mean = float(solved.mean()) if len(solved) else None
        rows.append((kind, f'{len(solved)} of {len(times)}', number(mean, 2, 's')))
    return rows


def bounds_mapping(bounds: Bounds) -> dict[str, list[float | None]]:
    """Return plain values, fit for JSON: None where there is no path."""
    return {
        name: [finite_or_none(time) for time in times]
        for name, times in dataclasses.asdict(bounds).items()
    }
