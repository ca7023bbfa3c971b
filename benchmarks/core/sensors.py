"""
How much a robot loses that has to measure where everybody is: the same cases, told and measured.

    python benchmarks/core/sensors.py --episodes 200
    python benchmarks/core/sensors.py --split validation --set tracker.gate=5.0 surfaces.sectors=36

A scan becomes discs and detections become tracks, by the functions that the nodes use, but without
middleware and delay, so that the figures repeat exactly. Detections come 20 times, scans and
decisions 10 times per second of simulated time, as over ROS. The robot that is told everything
decides as often.
"""

import argparse
import dataclasses
from typing import Any

import numpy as np

from socialnav_core.config.mapping import parse_assignments
from socialnav_core.evaluation.report import rate_text
from socialnav_core.evaluation.run import asked_worlds
from socialnav_core.evaluation.statistics import mcnemar, wilson_interval
from socialnav_core.policies import load_policy
from socialnav_core.sensing import (
    beam_angles,
    DetectorSettings,
    Geometry,
    Pose,
    Rays,
    scan_beams,
    ScannerSettings,
    Sensors,
    SurfaceSettings,
    surrounding_discs,
    Tracker,
    TrackerSettings,
)
from socialnav_core.simulation import make_scenario, Outcome, Simulator
from socialnav_core.states import Agents, CrowdState
from socialnav_core.tables import markdown_table, number

TICK = 0.05
"""Time between two detections, s."""
TICKS_PER_DECISION = 2
WALL_MARGIN = 0.1
"""Returns so near to the walls, which the policy is told, are theirs, m."""
COUNTED = {
    'pedestrian hit': Outcome.COLLISION_PEDESTRIAN,
    'obstacle hit': Outcome.COLLISION_OBSTACLE,
    'out of bounds': Outcome.OUT_OF_BOUNDS,
    'time-out': Outcome.TIMEOUT,
}
HEAD = ('the robot', 'success', *COUNTED, 'time of successes')


@dataclasses.dataclass(frozen=True)
class Settings:
    """How badly is measured and how it is understood."""

    scanner: ScannerSettings = ScannerSettings(noise=0.02)
    detector: DetectorSettings = DetectorSettings(noise=0.05, missed=0.1)
    surfaces: SurfaceSettings = SurfaceSettings()
    tracker: TrackerSettings = TrackerSettings()
    pedestrian_radius: float = 0.35
    max_agents: int = 20
    walls_told: bool = True


class Perception:
    """The sensors of one robot and what it makes of them."""

    def __init__(self, settings: Settings, seed: int, case: int) -> None:
        self.settings = settings
        self.sensors = Sensors(settings.scanner, settings.detector, seed, case)
        self.tracker = Tracker(settings.tracker)
        self.tracks = self.tracker.update(-np.inf, np.zeros((0, 2)))

    def detect(self, state: CrowdState) -> None:
        """Take detections of the first world into account."""
        self.tracks = self.tracker.update(float(state.time[0]), self.sensors.detect(state))

    def agents(self, state: CrowdState) -> tuple[np.ndarray, ...]:
        """Return position, velocity, radius and static of whom the robot knows near by."""
        tracks, (discs, radii) = self.tracks, self._discs(state)
        position = np.concatenate([tracks.position, discs])
        velocity = np.concatenate([tracks.velocity, np.zeros_like(discs)])
        static = np.arange(len(position)) >= len(tracks.id)
        people = np.full(len(tracks.id), self.settings.pedestrian_radius)
        radius = np.concatenate([people, radii])
        gap = np.linalg.norm(position - state.robot.position[0], axis=1) - radius
        nearest = np.argsort(gap, kind='stable')[: self.settings.max_agents]
        return position[nearest], velocity[nearest], radius[nearest], static[nearest]

    def _discs(self, state: CrowdState) -> tuple[np.ndarray, np.ndarray]:
        """Return centres and radii of the discs that a scan of the first world becomes."""
        ranges = self.sensors.scan(state)
        first, second, *_, last = beam_angles(len(ranges)).tolist()
        geometry = Geometry(first, last, second - first, 0.0, np.inf)
        points, ends = scan_beams(ranges, geometry, reach=self.settings.scanner.range)
        position, surfaces = state.robot.position[0], self.settings.surfaces
        if self.settings.walls_told:
            bounds = float(state.bounds[0]) - WALL_MARGIN
            surfaces = dataclasses.replace(surfaces, bounds=bounds)
        place = Pose(*position.tolist(), float(state.robot.heading[0]))
        rays = Rays(position, place.placed(ends))
        people = np.full(len(self.tracks.id), self.settings.pedestrian_radius)
        known = self.tracks.position, people
        return surrounding_discs(place.placed(points), position, *known, surfaces, rays=rays)


def known(state: CrowdState, perceptions: list[Perception], settings: Settings) -> CrowdState:
    """Return the worlds as their robots know them."""
    worlds = [one.agents(only(state, world)) for world, one in enumerate(perceptions)]
    size = max(1, *(len(world[0]) for world in worlds))
    names = 'position', 'velocity', 'radius', 'static'
    agents = {
        name: np.stack([padded(world[field], size) for world in worlds])
        for field, name in enumerate(names)
    }
    valid = np.stack([np.arange(size) < len(world[0]) for world in worlds])
    bounds = state.bounds if settings.walls_told else np.full_like(state.bounds, np.inf)
    return dataclasses.replace(state, agents=Agents(**agents, valid=valid), bounds=bounds)


def only(state: CrowdState, world: int) -> CrowdState:
    """Return the state of one world."""
    return state.select(np.array([world]))


def padded(array: np.ndarray, size: int) -> np.ndarray:
    """Return an array with zeros up to a size along its first axis."""
    return np.pad(array, [(0, size - len(array))] + [(0, 0)] * (array.ndim - 1))


def run(given: argparse.Namespace, settings: Settings | None) -> tuple[np.ndarray, np.ndarray]:
    """
    Run all cases side by side; return the outcome and the duration of each.

    :param settings: of the sensors; None for a robot that is told everything.
    """
    count, policy = given.episodes, load_policy(given.model)
    simulator = Simulator(make_scenario(given.scenario), count, autoreset='disabled')
    state = simulator.reset(given.seed, given.split, np.arange(count))
    perceptions = [Perception(settings, given.seed, case) for case in range(count) if settings]
    command, outcome, duration = np.zeros((count, 2)), np.zeros(count, int), np.zeros(count)
    tick = 0
    policy.reset()
    while simulator.active.any():
        asked = asked_worlds(policy, simulator.active)
        seen = state.select(asked)
        awake = [perceptions[world] for world in np.flatnonzero(asked) if settings]
        for world, perception in enumerate(awake):
            perception.detect(only(seen, world))
        if tick % TICKS_PER_DECISION == 0:
            command[asked] = policy.act(known(seen, awake, settings) if settings else seen)
        state, _, terminated, truncated, info = simulator.advance(command, TICK)
        ended = terminated | truncated
        outcome[ended], duration[ended] = info['outcome'][ended], info['time'][ended]
        tick += 1
    return outcome, duration


def row(name: str, outcome: np.ndarray, duration: np.ndarray) -> list[str]:
    """Return how cases ended as the cells of HEAD."""
    goal = outcome == Outcome.GOAL
    counts = [str(np.count_nonzero(outcome == code)) for code in COUNTED.values()]
    interval = wilson_interval(np.count_nonzero(goal), len(goal))
    mean = number(duration[goal].mean() if goal.any() else None, 2, 's')
    return [name, rate_text(goal.mean(), interval), *counts, mean]


def changed(settings: Settings, assignments: dict[str, Any]) -> Settings:
    """Return settings with some fields changed, such as tracker.hits."""
    for key, value in assignments.items():
        name, _, field = key.partition('.')
        if field:
            value = dataclasses.replace(getattr(settings, name), **{field: value})
        settings = dataclasses.replace(settings, **{name: value})
    return settings


def parse() -> argparse.Namespace:
    """Return the options of the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument('--model', default='gat4sn', help='folder or name of a model, or orca')
    parser.add_argument('--scenario', default='hard', help='world (hard)')
    parser.add_argument('--episodes', type=int, default=200, help='cases (200)')
    parser.add_argument('--seed', type=int, default=0, help='seed of cases and noise (0)')
    parser.add_argument('--split', default='test', help='test or validation (test)')
    parser.add_argument(
        '--set', nargs='*', default=[], dest='assignments', metavar='KEY=VALUE',
        help='change what is measured or made of it, such as tracker.coast_time=1.0',
    )  # fmt: skip
    return parser.parse_args()


def main() -> None:
    """Run the cases both ways and print a table."""
    given = parse()
    settings = changed(Settings(), parse_assignments(given.assignments))
    print(f'{given.model}, {given.scenario}, {given.split} cases, seed {given.seed}\n')
    told, measured = run(given, None), run(given, settings)
    rows = [
        row('is told everything', *told),
        row(' '.join(['measures', *given.assignments]), *measured),
    ]
    print(markdown_table(HEAD, rows))
    test = mcnemar(*(outcome == Outcome.GOAL for outcome, _ in (told, measured)))
    print(
        f'\nonly told: {test.first_only}, only measured: {test.second_only}, p {test.p_value:.2g}'
    )


if __name__ == '__main__':
    main()
