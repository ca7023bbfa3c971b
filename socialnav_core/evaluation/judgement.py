"""Predictions beside what people did: how far off, and whether they knew it."""

from collections.abc import Iterable
import dataclasses
import math
from statistics import NormalDist

import numpy as np

from socialnav_core.config import ConfigError
from socialnav_core.prediction.protocol import Prediction, Predictor
from socialnav_core.states import CrowdState

TIMES = np.array([0.25, 0.5, 1.0, 2.0, 3.0])
"""Times ahead at which predictions are judged, s."""
LEVELS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99)
"""Shares of a Gaussian whose counterparts are measured."""
FACTORS = (1.0, 2.0, *(NormalDist().inv_cdf(0.5 + 0.5 * level) for level in LEVELS))
"""Deviations within which errors are counted."""
MOTIONS = ('new', 'standing', 'starting', 'turning', 'walking')
"""Seen for less than NEW; stands and stays; stands and leaves; walks and turns; walks on."""
NEW = 0.5  # s
STANDING = 0.2  # m/s, also m within the next second
TURNING = math.cos(math.radians(30.0))
SECOND = int(np.flatnonzero(TIMES == 1.0)[0])

Moment = tuple[CrowdState, np.ndarray]
"""A state, and the true positions at TIMES, m, (batch, times, agents, 2), NaN where unknown."""


@dataclasses.dataclass(frozen=True)
class PredictionResult:
    """Means over all people who are seen for the whole time; lists are over TIMES."""

    crowd: str
    """Whom it was measured on."""
    noise: bool
    """Whether positions and velocities were seen with noise."""
    motion: str
    """One of MOTIONS, or all."""
    people: int
    """Number of predictions."""
    error: list[float]
    """Distance between prediction (weighted by its modes) and truth, m."""
    constant_velocity: list[float]
    """The same of constant velocity, m."""
    surprise: list[float]
    """Negative logarithm of the density that was predicted where people went, nats."""
    within_one: list[float]
    """Share of the errors along an axis within one standard deviation; a Gaussian has .683."""
    within_two: list[float]
    """The same for two; a Gaussian has .954."""
    within_level: list[list[float]]
    """Shares of the errors that are where a Gaussian has the shares LEVELS, by time."""


@dataclasses.dataclass
class Judgements:
    """What was found for each person and moment; arrays are (people, times, ...)."""

    motion: np.ndarray
    """Index into MOTIONS, (people,)."""
    error: np.ndarray
    """Distance to the truth, m."""
    constant: np.ndarray
    """The same of constant velocity, m."""
    surprise: np.ndarray
    """Negative logarithm of the predicted density, nats."""
    within: np.ndarray
    """Share of the two axes along which the error is within FACTORS, (people, times, factors)."""


def judge(predictor: Predictor, recordings: Iterable[Iterable[Moment]], crowd: str) -> Judgements:
    """
    Return how a predictor does at all moments of some recordings, shown in order.

    :raises ConfigError: when there is nobody to judge it on.
    """
    rows = []
    for moments in recordings:
        predictor.reset()
        since = np.empty(0)
        for state, truth in moments:
            since = seen_since(state, since)
            rows.append(judged(predictor, state, truth, since))
    if not any(len(row.motion) for row in rows):
        raise ConfigError(f'{crowd}: nobody is seen for {TIMES[-1]:g} s')
    names = [field.name for field in dataclasses.fields(Judgements)]
    return Judgements(*(np.concatenate([getattr(row, name) for row in rows]) for name in names))


def summarise(
    found: Judgements, crowd: str, noise: bool = False, motions: bool = False
) -> list[PredictionResult]:
    """Return the means over all people, with `motions` also over those of each motion."""
    everybody = np.ones(len(found.motion), bool)
    results = [means(found, everybody, crowd, noise, 'all')]
    for index, motion in enumerate(MOTIONS if motions else ()):
        kept = found.motion == index
        if kept.any():
            results.append(means(found, kept, crowd, noise, motion))
    return results


def means(
    found: Judgements, kept: np.ndarray, crowd: str, noise: bool, motion: str
) -> PredictionResult:
    """Return the means over some of the people, (people,)."""
    within = found.within[kept].mean(axis=0)
    columns = (
        found.error[kept].mean(axis=0), found.constant[kept].mean(axis=0),
        found.surprise[kept].mean(axis=0), within[:, 0], within[:, 1], within[:, 2:],
    )  # fmt: skip
    values = (column.tolist() for column in columns)
    return PredictionResult(crowd, noise, motion, int(kept.sum()), *values)


def seen_since(state: CrowdState, before: np.ndarray) -> np.ndarray:
    """Return since when each agent is seen without a break, s, (batch, agents)."""
    now = np.broadcast_to(state.time[:, None], state.agents.valid.shape)
    if before.shape != now.shape:
        before = now
    return np.where(state.agents.valid, np.minimum(before, now), np.inf)


def judged(
    predictor: Predictor, state: CrowdState, truth: np.ndarray, since: np.ndarray
) -> Judgements:
    """Return what is found at a moment; `since` is as `seen_since` says."""
    prediction = predictor.predict(state, TIMES)
    agents = state.agents
    constant = agents.position[:, None] + agents.velocity[:, None] * TIMES[:, None, None]
    people = (agents.valid & ~agents.static) & np.isfinite(truth).all(axis=(1, 3))
    miss = prediction.positions - truth[:, None]
    weights = prediction.weights[:, :, None, None]
    distance = (weights * np.linalg.norm(miss, axis=-1)).sum(axis=1)
    limits = prediction.deviations[..., None, None] * np.array(FACTORS)
    within = (np.abs(miss)[..., None] <= limits).mean(axis=-2)
    within = (weights[..., None] * within).sum(axis=1)
    columns = (
        distance, np.linalg.norm(constant - truth, axis=-1), surprise(prediction, miss), within
    )  # fmt: skip
    motion = motions_of(state, truth, since)
    return Judgements(motion[people], *(array.swapaxes(1, 2)[people] for array in columns))


def surprise(prediction: Prediction, miss: np.ndarray) -> np.ndarray:
    """
    Return the negative logarithm of the density at the truth, nats, (batch, times, agents).

    :param miss: of each mode, m, (batch, modes, times, agents, 2).
    """
    deviation = prediction.deviations
    exponent = -0.5 * (miss**2).sum(axis=-1) / deviation**2
    logarithm = exponent - np.log(2.0 * np.pi * deviation**2)
    with np.errstate(divide='ignore'):  # a mode may have no weight
        logarithm += np.log(prediction.weights)[:, :, None, None]
    largest = logarithm.max(axis=1)
    return -(largest + np.log(np.exp(logarithm - largest[:, None]).sum(axis=1)))


def motions_of(state: CrowdState, truth: np.ndarray, since: np.ndarray) -> np.ndarray:
    """Return what each agent is about to do, an index into MOTIONS, (batch, agents)."""
    velocity = state.agents.velocity
    way = truth[:, SECOND] - state.agents.position
    speed, length = np.linalg.norm(velocity, axis=-1), np.linalg.norm(way, axis=-1)
    ahead = (velocity * way).sum(axis=-1)
    new = state.time[:, None] - since < NEW
    stands = speed < STANDING
    chosen = (
        new, stands & (length < STANDING), stands, ahead < TURNING * speed * length
    )  # fmt: skip
    return np.select(chosen, range(4), 4)
