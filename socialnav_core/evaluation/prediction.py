"""How far predictions are from what people did, and whether they know it."""

from collections.abc import Iterable, Iterator
import dataclasses

import numpy as np

from socialnav_core.config import ConfigError, make_scenario
from socialnav_core.config.prediction import CrowdsConfig, NoiseConfig, SHARES
from socialnav_core.prediction.protocol import Predictor
from socialnav_core.states import CrowdState
from socialnav_core.training.prediction.crowds import Crowd
from socialnav_core.training.prediction.dataset import record_fitting
from socialnav_core.training.prediction.recording import Recording
from socialnav_core.training.randomness import generator, Purpose

TIMES = np.array([0.25, 0.5, 1.0, 2.0, 3.0])
"""Times ahead at which predictions are judged, s."""
NAMED = ('crowd20', 'hard', 'packed-2.5')
CROWDS = (*NAMED, *SHARES[1:])
"""Crowds that predictions are judged on: scenarios, then kinds of the training's mixture."""

Moment = tuple[CrowdState, np.ndarray]
"""A state, and the true positions at TIMES, m, (batch, times, agents, 2), NaN where unknown."""


@dataclasses.dataclass(frozen=True)
class PredictionResult:
    """Means over all people who moved or stood for the whole time; lists are over TIMES."""

    crowd: str
    """Whom it was measured on."""
    noise: bool
    """Whether positions and velocities were seen with noise."""
    people: int
    """Number of predictions."""
    error: list[float]
    """Distance between prediction (weighted by its modes) and truth, m."""
    constant_velocity: list[float]
    """The same of constant velocity, m."""
    within_one: list[float]
    """Share of the errors along an axis within one standard deviation; a Gaussian has .683."""
    within_two: list[float]
    """The same for two; a Gaussian has .954."""


def evaluate_prediction(
    predictor: Predictor,
    crowd: str,
    groups: int = 6,
    seed: int = 0,
    split: str = 'test',
    noise: bool = False,
) -> PredictionResult:
    """
    Return how well people of a crowd are predicted at every moment of some recordings.

    :param crowd: one of CROWDS.
    :param groups: recordings, of 12 worlds each; each draws its own settings.
    :param split: of the layouts: validation or test.
    :param noise: whether measurements are as noisy as in training at most.
    """
    config, number = CrowdsConfig(), CROWDS.index(crowd)
    fixed = Crowd('scenarios', make_scenario(crowd)) if crowd in NAMED else crowd
    moments: list[Iterator[Moment]] = []
    for group in range(groups):
        draws = generator(seed, Purpose.EVALUATION_CROWDS, number << 32 | group)
        recording = record_fitting(fixed, config, split, seed, group, draws)
        seen = recording
        if noise:
            level = NoiseConfig()
            seen = recording.noisy(level.position, level.velocity, draws)
        moments.append(recorded_moments(recording, seen))
    return measure_prediction(predictor, moments, crowd, noise)


def recorded_moments(recording: Recording, seen: Recording) -> Iterator[Moment]:
    """
    Yield what is seen at each moment of a recording, and the truth.

    :param seen: the recording as sensors see it.
    """
    worlds = np.arange(recording.worlds)
    last = recording.moments - 1 - round(TIMES[-1] / recording.time_step + 0.49)
    for moment in range(last + 1):
        state = seen.state(moment)
        truth = np.full((recording.worlds, len(TIMES), state.agents.count, 2), np.nan)
        now = np.full(recording.worlds, moment)
        truth[:, :, : recording.people] = recording.future(worlds, now, TIMES)
        yield state, truth


def measure_prediction(
    predictor: Predictor, recordings: Iterable[Iterable[Moment]], crowd: str, noise: bool = False
) -> PredictionResult:
    """
    Return how a predictor does at all moments of some recordings, shown in order.

    :raises ConfigError: when there is nobody to judge it on.
    """
    rows = []
    for moments in recordings:
        predictor.reset()
        rows += [judged(predictor, *moment) for moment in moments]
    if not any(len(row[0]) for row in rows):
        raise ConfigError(f'{crowd}: nobody is seen for {TIMES[-1]:g} s')
    columns = zip(*rows, strict=True)
    error, constant, one, two = (np.concatenate(parts).mean(axis=0) for parts in columns)
    people = sum(len(row[0]) for row in rows)
    return PredictionResult(
        crowd, noise, people, error.tolist(), constant.tolist(), one.tolist(), two.tolist()
    )


def judged(predictor: Predictor, state: CrowdState, truth: np.ndarray) -> tuple[np.ndarray, ...]:
    """
    Return distances, those of constant velocity, and who is within one and two deviations.

    Each is (people, times).
    """
    prediction = predictor.predict(state, TIMES)
    agents = state.agents
    constant = agents.position[:, None] + agents.velocity[:, None] * TIMES[:, None, None]
    people = (agents.valid & ~agents.static)[:, None] & np.isfinite(truth).all(axis=3)
    people &= people.all(axis=1, keepdims=True)
    miss = prediction.positions - truth[:, None]
    distance = np.linalg.norm(miss, axis=-1)
    inside = [
        (np.abs(miss) <= factor * prediction.deviations[..., None]).mean(axis=-1)
        for factor in (1, 2)
    ]
    weights = prediction.weights[:, :, None, None]
    averaged = [(weights * array).sum(axis=1) for array in (distance, *inside)]
    plain = np.linalg.norm(constant - truth, axis=-1)
    kept = [array.transpose(0, 2, 1)[people[:, 0]] for array in (plain, *averaged)]
    return kept[1], kept[0], kept[2], kept[3]
