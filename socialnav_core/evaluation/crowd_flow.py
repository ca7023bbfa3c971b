"""
How a crowd walks in a corridor without ends: speed by density, and whether lanes form.

The corridor is closed to a torus: eight copies of everybody lie around it, as agents who move with
those whom they copy.
"""

from collections.abc import Iterable, Iterator
import dataclasses
import math

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.config.scenario import LAYOUTS
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.protocol import Crowd, make_crowd
from socialnav_core.simulation.random_streams import GOALS, stream

LENGTH, WIDTH = 10.0, 5.0
"""Of the corridor, m."""
DENSITIES = (0.2, 0.5, 1.0, 1.5)
"""People per square metre."""
SETTLING, DURATION = 20.0, 60.0
"""Time before anything is measured, and in all, s."""
FAR = 100.0
"""People want to go so far ahead, m: none arrives."""
LANE = 0.6
"""Who walks within this to the left or right of somebody walks in their lane, m."""
COPIES = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if (x, y) != (0, 0)]


@dataclasses.dataclass(frozen=True)
class Flow:
    """What was measured of a crowd at a density."""

    crowd: str
    """Its name."""
    density: float
    """People per square metre."""
    two_ways: bool
    """Whether half of the people walk the other way."""
    speed: float
    """Mean speed ahead, in units of what people prefer."""
    lanes: float
    """Order of lanes in the last 10 s, 0 to 1; see `lane_order`."""
    lanes_at_start: float
    """The same when people have just been put anywhere."""
    overlap: float
    """Share of people who are nearer to somebody than their radii allow by over 1 cm."""


def weidmann(density: float) -> float:
    """
    Return the speed of real people at a density, in units of their free speed.

    Source: U. Weidmann, Transporttechnik der Fussgaenger, ETH Zurich, 1993.
    """
    return 1.0 - math.exp(-1.913 * (1.0 / density - 1.0 / 5.4)) if density < 5.4 else 0.0


def measure_flow(
    crowd: str, density: float, two_ways: bool, worlds: int = 2, seed: int = 0
) -> Flow:
    """
    Return how a crowd walks at a density.

    People have the size, the speed and the settings of ORCA of the package's scenarios.

    :param crowd: a name in CROWDS.
    :param worlds: corridors whose means are returned.
    """
    corridor = Corridor(crowd, density, two_ways, worlds, seed)
    step = corridor.scenario.time_step
    speeds, orders, overlaps = [], [], []
    first = lane_order(corridor.position, corridor.ahead)
    for number in range(round(DURATION / step)):
        speed = corridor.step()
        if number * step >= SETTLING:
            speeds.append(speed)
            overlaps.append(overlap_share(corridor.position, corridor.scenario.pedestrian_radius))
        if number * step >= DURATION - 10.0:
            orders.append(lane_order(corridor.position, corridor.ahead))
    return Flow(
        crowd, density, two_ways, float(np.mean(speeds)), float(np.mean(orders)), first,
        float(np.mean(overlaps)),
    )  # fmt: skip


def measure_flows(
    crowds: Iterable[str], densities: Iterable[float] = DENSITIES, seed: int = 0
) -> Iterator[Flow]:
    """Yield the flows of some crowds, one way and two ways, at some densities."""
    for crowd in crowds:
        for two_ways in (False, True):
            for density in densities:
                yield measure_flow(crowd, density, two_ways, seed=seed)


class Corridor:
    """People in corridors without ends."""

    def __init__(self, crowd: str, density: float, two_ways: bool, worlds: int, seed: int) -> None:
        """Put people anywhere, as far apart as there is room for."""
        people = round(density * LENGTH * WIDTH)
        self.scenario = Scenario(
            'corridor', pedestrians=people, obstacles=len(COPIES) * people, crowd=crowd,
            layout=LAYOUTS[0], bounds=math.inf, minimum_travel=0.1,
        )  # fmt: skip
        self._episodes = episodes = Episodes(self.scenario, worlds)
        generator = np.random.default_rng([seed, people, two_ways])
        self.position = np.stack([scattered(people, generator) for _ in range(worlds)])
        self.ahead = np.where(np.arange(people) % 2 * two_ways, -1.0, 1.0) * np.ones((worlds, 1))
        agents = episodes.state.agents
        agents.radius[:], agents.static[:] = self.scenario.pedestrian_radius, False
        episodes.preferred_speed[:] = self.scenario.pedestrian_speed
        episodes.case_index[:] = np.arange(worlds)
        for world in range(worlds):
            for person in range(people):
                episodes.goal_streams[world, person] = stream('test', seed, world, GOALS, person)
        episodes.state.robot.position[:] = 1e6
        self._crowd: Crowd = make_crowd(self.scenario, worlds)
        self._show()
        self._crowd.reset(episodes, np.arange(worlds))
        self.leaders = getattr(self._crowd, 'leaders', np.tile(np.arange(people), (worlds, 1)))
        self.ahead = np.take_along_axis(self.ahead, self.leaders, axis=1)
        self.position = agents.position[:, :people].copy()
        self._decided = np.zeros_like(agents.velocity)

    def step(self) -> float:
        """Let people walk for a time step; return their mean speed ahead in preferred ones."""
        self._show()
        episodes, people = self._episodes, self.position.shape[1]
        due = np.ones(len(self.position), bool)
        self._crowd.decide(episodes, due, self._decided)
        velocity = self._decided[:, :people].copy()
        self.position += velocity * self.scenario.time_step
        episodes.state.time += self.scenario.time_step
        first = np.take_along_axis(self.position, self.leaders[..., None], axis=1)
        size = np.array([LENGTH, WIDTH])
        self.position -= size * np.floor(first / size)  # a group enters as one
        episodes.state.agents.velocity[:] = np.tile(velocity, (1, 1 + len(COPIES), 1))
        return float((velocity[..., 0] * self.ahead).mean()) / self.scenario.pedestrian_speed

    def _show(self) -> None:
        """Show the crowd where everybody, every copy and every goal is."""
        parts = [self.position] + [self.position + (x * LENGTH, y * WIDTH) for x, y in COPIES]
        self._episodes.state.agents.position[:] = np.concatenate(parts, axis=1)
        way = np.stack([FAR * self.ahead, np.zeros_like(self.ahead)], axis=-1)
        self._episodes.goal[:, : way.shape[1]] = self.position + way


def scattered(people: int, generator: np.random.Generator) -> np.ndarray:
    """Return places in the corridor, m, (people, 2): each the best of 30 draws."""
    places = np.empty((people, 2))
    for i in range(people):
        draws = generator.uniform((0.0, 0.0), (LENGTH, WIDTH), (30, 2))
        gaps = np.linalg.norm(torus(draws[:, None] - places[None, :i]), axis=-1)
        places[i] = draws[gaps.min(axis=1, initial=np.inf).argmax()]
    return places


def torus(offset: np.ndarray) -> np.ndarray:
    """Return the shortest ways between points of the corridor, m, (..., 2)."""
    size = np.array([LENGTH, WIDTH])
    return offset - size * np.rint(offset / size)


def lane_order(position: np.ndarray, ahead: np.ndarray) -> float:
    """
    Return how far people walk in lanes, 0 to 1.

    For each person: the square of (those in their lane who walk their way - those who do not) over
    both; lanes of one way have 1. Who is alone there does not count.

    Source: M. Rex and H. Loewen, Lane formation in oppositely charged colloids driven by an
    electric field, Physical Review E 75, 2007.

    :param position: m, (worlds, people, 2).
    :param ahead: 1 or -1, (worlds, people).
    """
    beside = np.abs(torus(position[:, :, None] - position[:, None])[..., 1]) < LANE
    beside &= ~np.eye(position.shape[1], dtype=bool)
    same = ahead[:, :, None] * ahead[:, None]
    count = beside.sum(axis=2)
    balance = (beside * same).sum(axis=2) / np.maximum(count, 1)
    return float((balance**2)[count > 0].mean()) if (count > 0).any() else math.nan


def overlap_share(position: np.ndarray, radius: float) -> float:
    """Return the share of people who overlap somebody by more than 1 cm."""
    gap = np.linalg.norm(torus(position[:, :, None] - position[:, None]), axis=-1) - 2.0 * radius
    gap += 1e3 * np.eye(position.shape[1])
    return float((gap.min(axis=2) < -0.01).mean())
