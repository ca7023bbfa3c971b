"""Metrics of how near the robot comes to others."""

from collections.abc import Callable
from functools import partial

import numpy as np

from socialnav_core.metrics.outcomes import FRANCIS
from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import Average, Metric, Place

INTRUSION_DISTANCE = 0.2
"""Gap to a pedestrian below which a step counts as an intrusion, m."""
FORESEEN_DISTANCE = 0.6
"""Distance of centres to a future person below which CrowdNav++ speaks of an intrusion, m."""
FORESEEN_STEPS = 5
FORESEEN_RANGE = 5.0
"""Gap beyond which people are not visible there, m."""
SPACES = {'intimate': 0.45, 'personal': 1.2, 'social': 3.6}
"""Outer limits of the spaces around a person, m."""


def intrusions(records: EpisodeRecords) -> np.ndarray:
    """Return the number of steps below INTRUSION_DISTANCE to a pedestrian, (episodes,)."""
    return (records.pedestrian_clearance < INTRUSION_DISTANCE).sum(axis=1)


def steps_outside(limit: float) -> Callable[[EpisodeRecords], np.ndarray]:
    """Return the measure of the number of steps with at least a gap, m, to every pedestrian."""
    return partial(_steps_outside, limit)


def _steps_outside(limit: float, records: EpisodeRecords) -> np.ndarray:
    """Return the number of steps with at least a gap, m, to every pedestrian, (episodes,)."""
    return (records.pedestrian_clearance >= limit).sum(axis=1)  # NaN behind the end: False


def foreseen_intrusions(records: EpisodeRecords) -> np.ndarray:
    """Return the share of steps in which a person will soon be near, NaN: not asked."""
    distance = records.foreseen_distance
    share = (distance < FORESEEN_DISTANCE).sum(axis=1) / (records.steps + 1)
    return np.where(np.isnan(distance[:, 0]), np.nan, share)


def least(values: np.ndarray) -> np.ndarray:
    """Return the least value of each episode, (episodes,), of an array (episodes, steps)."""
    return np.fmin.reduce(values, axis=1)  # NaN behind the end does not count


METRICS = (
    Metric(
        name='minimum_clearance_mean', label='least clearance, mean', heading='clearance',
        unit='m', digits=2, episode_key='minimum_clearance', places=frozenset({Place.EVALUATION}),
        measure=lambda records: records.minimum_clearance, average=Average.EPISODES,
        source=FRANCIS,
        formula='least gap between the rims of the robot and any agent, between steps too; '
        'episodes without agents do not count',
    ),
    Metric(
        name='intrusion_rate', label=f'steps within {INTRUSION_DISTANCE:g} m of people',
        heading='intrusion', places=frozenset({Place.EVALUATION, Place.COMPARISON}),
        measure=intrusions, average=Average.STEPS,
        source='Chen et al. 2019, Crowd-Robot Interaction (discomfort distance)',
        formula=f'share of steps with a gap below {INTRUSION_DISTANCE:g} m to a pedestrian',
    ),
    Metric(
        name='minimum_people_distance', label='least distance to people, mean',
        heading='to people', unit='m', digits=2,
        measure=lambda records: least(records.pedestrian_clearance), average=Average.EPISODES,
        source=FRANCIS,
        formula='least gap between the rims of the robot and a pedestrian, between steps too; '
        'episodes without pedestrians do not count',
    ),
    *(
        Metric(
            name=f'{space}_space_compliance', label=f'steps outside of {space} space',
            heading=f'outside {limit:g} m', measure=steps_outside(limit), average=Average.STEPS,
            source='Hall 1966, The Hidden Dimension',
            formula=f'share of steps with a gap of at least {limit:g} m to every pedestrian',
        )
        for space, limit in SPACES.items()
    ),
    Metric(
        name='foreseen_intrusion_rate', label='steps near where people will be',
        heading='foreseen intrusion', measure=foreseen_intrusions, average=Average.EPISODES,
        source='Liu et al. 2023, Intention Aware Robot Crowd Navigation with Attention-Based '
        'Interaction Graph (intrusion ratio)',
        formula=f'share of the steps, the end counted as one, in which the centre of the robot is '
        f'within {FORESEEN_DISTANCE:g} m of where the centre of a person within '
        f'{FORESEEN_RANGE:g} m would be after 1 to {FORESEEN_STEPS} steps, if nobody changed '
        'their mind',
    ),
    Metric(
        name='minimum_time_to_collision', label='least time to collision, mean',
        heading='to collision', unit='s', digits=2,
        measure=lambda records: least(records.time_to_collision), average=Average.EPISODES,
        source='Hayward 1972, Near-miss Determination Through Use of a Scale of Danger',
        formula='least t >= 0 after any step with |p + v t| = r for a pedestrian: p and v its '
        'position and velocity relative to the robot, r the sum of the radii; episodes in which '
        'nobody is ever on a collision course do not count',
    ),
)  # fmt: skip
