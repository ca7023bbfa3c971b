"""Recorded people at the moments of a simulation, and where a robot starts among them."""

import dataclasses
import functools
import math

import numpy as np
from scipy.interpolate import CubicSpline

from socialnav_core.config import ConfigError, Scenario
from socialnav_core.config.appearances import appearances_of
from socialnav_core.config.recorded import centre_of
from socialnav_core.config.recordings import file_digest, read_tracks
from socialnav_core.simulation.layout import GAP, PackingError
from socialnav_core.simulation.motion import TIME_TOLERANCE
from socialnav_core.simulation.random_streams import LAYOUT, SPLITS, stream, uniform

NOBODY = -1
ATTEMPTS = 2000
CLEAR_TIME = 1.0
"""Nobody comes to where the robot starts within this time, s."""
WALKING = 0.5
"""The robot starts and arrives where somebody walked faster than this, m/s."""


@dataclasses.dataclass(frozen=True, eq=False)
class Replay:
    """A recording a time step at a time; a person keeps their slot as long as they are there."""

    position: np.ndarray
    """m, from the middle of the scene, (moments, slots, 2); 0 where there is nobody."""
    velocity: np.ndarray
    """Mean of the step that begins then, m/s, (moments, slots, 2)."""
    there: np.ndarray
    """Whether somebody is there, for a step at least and for one already, (moments, slots)."""
    places: np.ndarray
    """Where people walked, m, (places, 2)."""


@functools.lru_cache(maxsize=16)
def replay_of(scenario: Scenario) -> Replay:
    """
    Return the recording of a scenario.

    :raises ConfigError: when the file is another one by now, or has more people.
    """
    recording = scenario.recording
    digest = file_digest(recording.file)
    if recording.digest not in ('', digest):
        raise ConfigError(
            f'{recording.file} is not the file that scenario {scenario.name} was made of; make '
            'the scenario anew'
        )
    replay = _replay(recording.file, digest, recording.interval, scenario.time_step)
    if replay.there.shape[1] > scenario.pedestrians:
        raise ConfigError(
            f'scenario {scenario.name}: pedestrians must be at least {replay.there.shape[1]}, so '
            'many slots the people of the recording take'
        )
    return replay


@functools.lru_cache(maxsize=8)
def _replay(file: str, digest: str, interval: float, time_step: float) -> Replay:
    """Return the recording of a file whose digest is known."""
    tracks = read_tracks(file, interval)
    appearances = appearances_of(tracks, interval)
    moments = math.floor((len(tracks) - 1) * interval / time_step + TIME_TOLERANCE) + 1
    slots = max(each.slot for each in appearances) + 1
    position, who = np.zeros((moments + 1, slots, 2)), np.full((moments + 1, slots), NOBODY)
    centre = centre_of(tracks)
    for number, (person, frames, slot) in enumerate(appearances):
        times = frames * interval
        first = math.ceil(times[0] / time_step - TIME_TOLERANCE)
        last = min(math.floor(times[-1] / time_step + TIME_TOLERANCE), moments - 1)
        rows = np.arange(first, last + 1)
        curve = CubicSpline(times, tracks[frames, person] - centre, bc_type='natural')
        position[rows, slot], who[rows, slot] = curve(rows * time_step), number
    velocity = np.diff(position, axis=0) / time_step
    position, same = position[:-1], (who[1:] == who[:-1]) & (who[:-1] != NOBODY)
    there = same.copy()
    there[1:] &= same[:-1]  # so that everybody's velocity could be measured
    there[0] = False
    velocity[~same] = 0.0
    walked = there & (np.linalg.norm(velocity, axis=-1) > WALKING)
    return Replay(position, velocity, there, position[walked])


@functools.lru_cache(maxsize=16)
def first_moments(scenario: Scenario, split: str) -> np.ndarray:
    """
    Return the moments at which cases of a split may begin: somebody is there.

    The splits train, validation and test are the first, the second and the last third of the
    recording; a case lies in its own altogether.

    :raises ConfigError: when there is none.
    """
    there = replay_of(scenario).there
    number, thirds = SPLITS[split], len(SPLITS)
    begin, end = (len(there) * (number + k) // thirds for k in (0, 1))
    steps = math.ceil(scenario.time_limit / scenario.time_step - TIME_TOLERANCE) + 1
    moments = np.arange(max(begin, 1), end - steps)
    if not len(moments):
        raise ConfigError(
            f'scenario {scenario.name}: a third of the recording lasts '
            f'{(end - begin) * scenario.time_step:.3g} s, which must be longer than time_limit, '
            f'{scenario.time_limit:g} s'
        )
    moments = moments[there[moments].any(axis=1)]
    if not len(moments):
        raise ConfigError(f'scenario {scenario.name}: nobody is there in the {split} third')
    return moments


def first_moment(scenario: Scenario, split: str, seed: int, case: int) -> int:
    """Return the moment at which a case begins."""
    moments = first_moments(scenario, split)
    return int(moments[int(uniform(stream(split, seed, case, LAYOUT), 0.0, len(moments)))])


def robot_places(
    scenario: Scenario, split: str, seed: int, case: int
) -> tuple[np.ndarray, np.ndarray]:
    """
    Return where the robot of a case starts and where it shall arrive, m, (2,) each.

    Both are places where somebody walked at some time; nobody comes to the start within
    CLEAR_TIME, and nobody stands on the goal for most of the case. A start or goal that the
    scenario chooses is taken as it is.

    :raises PackingError: when no two such places are found.
    """
    replay, draws = replay_of(scenario), stream(split, seed, case, LAYOUT)
    draws[5] += np.uint64(1)  # behind the draw of the moment
    moment = first_moment(scenario, split, seed, case)
    until = moment + math.ceil(CLEAR_TIME / scenario.time_step) + 1
    there = replay.there[moment:until]
    people = replay.position[moment:until][there]
    keep = scenario.robot_radius + scenario.pedestrian_radius + GAP
    for _ in range(ATTEMPTS if len(replay.places) else 0):
        start, goal = (
            replay.places[int(uniform(draws, 0.0, len(replay.places)))] for _ in range(2)
        )
        start = start if scenario.robot_start is None else np.array(scenario.robot_start)
        goal = goal if scenario.robot_goal is None else np.array(scenario.robot_goal)
        chosen = scenario.robot_start is not None and scenario.robot_goal is not None
        way = float(np.linalg.norm(goal - start))
        free = (
            scenario.robot_start is not None
            or not (np.linalg.norm(people - start, axis=1) < keep).any()
        )
        apart = scenario.minimum_travel <= way <= scenario.maximum_travel
        if chosen or (free and apart and is_open(replay, scenario, moment, goal)):
            return start, goal
    raise PackingError(
        f'scenario {scenario.name}: no start and goal {scenario.minimum_travel:g} to '
        f'{scenario.maximum_travel:g} m apart were found among the places where recorded people '
        f'walked (case {case}); change minimum_travel or maximum_travel'
    )


def is_open(replay: Replay, scenario: Scenario, moment: int, goal: np.ndarray) -> bool:
    """Return whether a robot could arrive in comfort for half of the case at least."""
    case = slice(moment, moment + math.ceil(scenario.time_limit / scenario.time_step))
    touch = scenario.robot_radius + scenario.pedestrian_radius - scenario.goal_tolerance
    near = np.linalg.norm(replay.position[case] - goal, axis=-1) < touch + GAP
    return bool((near & replay.there[case]).any(axis=1).mean() <= 0.5)
