"""How far predictions are from what people did, and whether they know it."""

from collections.abc import Iterator

import numpy as np

from socialnav_core.config import make_scenario
from socialnav_core.config.prediction import CrowdsConfig, NoiseConfig, SHARES
from socialnav_core.evaluation.judgement import judge, Moment, PredictionResult, summarise, TIMES
from socialnav_core.prediction.protocol import Predictor
from socialnav_core.training.prediction.crowds import Crowd
from socialnav_core.training.prediction.dataset import record_fitting
from socialnav_core.training.prediction.recording import Recording
from socialnav_core.training.randomness import generator, Purpose

NAMED = ('crowd20', 'hard', 'packed-2.5')
CROWDS = (*NAMED, *SHARES[1:])
"""Crowds that predictions are judged on: scenarios, then kinds of the training's mixture."""


def evaluate_prediction(
    predictor: Predictor,
    crowd: str,
    groups: int = 6,
    seed: int = 0,
    split: str = 'test',
    noise: bool = False,
    motions: bool = False,
) -> list[PredictionResult]:
    """
    Return how well people of a crowd are predicted at every moment of some recordings.

    :param crowd: one of CROWDS.
    :param groups: recordings, of 12 worlds each; each draws its own settings.
    :param split: of the layouts: validation or test.
    :param noise: whether measurements are as noisy as in training at most.
    :param motions: whether a result for each kind of motion follows that of all people.
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
    return summarise(judge(predictor, moments, crowd), crowd, noise, motions)


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
