"""Metrics of how episodes end."""

from collections.abc import Callable
from functools import partial

import numpy as np

from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import Average, Metric, Place
from socialnav_core.simulation import Outcome

COLLISIONS = (Outcome.COLLISION_PEDESTRIAN, Outcome.COLLISION_OBSTACLE, Outcome.OUT_OF_BOUNDS)
EVERYWHERE = frozenset(Place)
FRANCIS = 'Francis et al. 2023, Principles and Guidelines for Evaluating Social Robot Navigation'


def ended_in(*outcomes: Outcome) -> Callable[[EpisodeRecords], np.ndarray]:
    """Return the measure of whether an episode ended in one of some outcomes."""
    return partial(_ended_in, outcomes)


def _ended_in(outcomes: tuple[Outcome, ...], records: EpisodeRecords) -> np.ndarray:
    """Return whether each episode ended in one of some outcomes, bool (episodes,)."""
    return np.isin(records.outcome, outcomes)


METRICS = (
    Metric(
        name='success_rate', label='success', episode_key=None, places=EVERYWHERE,
        measure=ended_in(Outcome.GOAL), average=Average.EPISODES, source=FRANCIS,
        formula='share of episodes in which the robot reaches the goal in time, untouched',
    ),
    Metric(
        name='collision_rate', label='collision', episode_key=None, places=EVERYWHERE,
        measure=ended_in(*COLLISIONS), average=Average.EPISODES, source=FRANCIS,
        formula='share of episodes that end in a collision, with the walls too',
    ),
    Metric(
        name='collision_pedestrian_rate', label='  with a pedestrian', episode_key=None,
        places=frozenset({Place.EVALUATION}),
        measure=ended_in(Outcome.COLLISION_PEDESTRIAN), average=Average.EPISODES, source=FRANCIS,
        formula='share of episodes that end at a pedestrian',
    ),
    Metric(
        name='collision_obstacle_rate', label='  with an obstacle', episode_key=None,
        places=frozenset({Place.EVALUATION}),
        measure=ended_in(Outcome.COLLISION_OBSTACLE), average=Average.EPISODES, source=FRANCIS,
        formula='share of episodes that end at a static obstacle',
    ),
    Metric(
        name='out_of_bounds_rate', label='  out of bounds', episode_key=None,
        places=frozenset({Place.EVALUATION}),
        measure=ended_in(Outcome.OUT_OF_BOUNDS), average=Average.EPISODES, source=FRANCIS,
        formula='share of episodes that end at the walls of the world',
    ),
    Metric(
        name='timeout_rate', label='time-out', episode_key=None, places=EVERYWHERE,
        measure=ended_in(Outcome.TIMEOUT), average=Average.EPISODES, source=FRANCIS,
        formula='share of episodes that the time limit ends',
    ),
)  # fmt: skip
