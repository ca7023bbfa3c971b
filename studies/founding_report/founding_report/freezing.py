"""Finds cases in which a robot stands still near an obstacle until its time is up."""

from collections.abc import Iterable, Iterator
import dataclasses

import numpy as np

from founding_report.laboratory import Laboratory
from founding_report.measurements import Cases
from founding_report.rows import Row
from socialnav_core.policies import load_policy
from socialnav_core.simulation import make_scenario
from socialnav_core.viewing import record, Recording

STANDING_SECONDS = 5.0
"""A robot stands still when it has hardly moved for so long, s."""
STANDING_DISTANCE = 0.3
"""How far it may have gone meanwhile, m."""
NEAR = 0.6
"""Largest gap to the obstacle near which it stands, m."""
LARGE = 0.45
"""Least radius of a large obstacle, m."""


@dataclasses.dataclass(frozen=True)
class Found:
    """A recorded case of a trained run."""

    row: Row
    seed: int
    """Training seed."""
    cases: Cases
    """The frozen cases that it is one of."""
    recording: Recording


def time_outs(
    row: Row, seeds: Iterable[int], cases: Cases, laboratory: Laboratory
) -> Iterator[tuple[int, int]]:
    """Yield training seed and index of the cases in which time ran out, the first cases first."""
    found = [
        (int(case), seed)
        for seed in seeds
        for case in np.flatnonzero(laboratory.measurement(row, seed, cases).timeout)
    ]
    yield from ((seed, case) for case, seed in sorted(found))


def frozen_cases(
    row: Row, seeds: Iterable[int], cases: Cases, laboratory: Laboratory
) -> Iterator[Found]:
    """Yield cases in which the robot stands still near a large obstacle to the end."""
    for seed, case in time_outs(row, seeds, cases, laboratory):
        found = play(row, seed, cases, case, laboratory)
        if stands_near_obstacle(found.recording):
            yield found


def play(row: Row, seed: int, cases: Cases, case: int, laboratory: Laboratory) -> Found:
    """Run a case again and record it."""
    folder = cases.checkpoint(laboratory.run(row, seed))
    policy = load_policy(str(folder), lookahead=cases.lookahead, screening=False)
    scenario = make_scenario(cases.scenario)
    name = f'{row.label}, seed {seed}'
    return Found(row, seed, cases, record(policy, scenario, 0, case, cases.split, name))


def stands_near_obstacle(recording: Recording) -> bool:
    """Return whether the robot ends its time at rest near a large obstacle."""
    if recording.outcome != 'timeout':
        return False
    since = standing_since(recording)
    state = recording.states[-1]
    gaps = np.linalg.norm(state.agents.position[0] - state.robot.position[0], axis=-1)
    gaps -= state.agents.radius[0] + state.robot.radius[0]
    large = state.agents.valid[0] & state.agents.static[0] & (state.agents.radius[0] >= LARGE)
    still = recording.times[-1] - recording.times[since] >= STANDING_SECONDS
    return bool(still and gaps[large].min(initial=np.inf) <= NEAR)


def standing_since(recording: Recording) -> int:
    """Return the index of the state from which on the robot stays where it is in the end."""
    path = recording.robot_path
    away = np.linalg.norm(path - path[-1], axis=-1) > STANDING_DISTANCE
    return int(np.flatnonzero(away)[-1]) + 1 if away.any() else 0
