"""The crowds of a run, recorded anew from its seed whenever they are needed."""

import numpy as np

from socialnav_core.config.prediction import CrowdsConfig
from socialnav_core.simulation.layout import PackingError
from socialnav_core.training.prediction.crowds import draw_crowd, record
from socialnav_core.training.prediction.recording import Recording
from socialnav_core.training.randomness import generator, Purpose

ATTEMPTS = 20
"""Crowds that are drawn, at most, until one fits into its world."""


def record_crowds(config: CrowdsConfig, seed: int, split: str) -> list[Recording]:
    """
    Return the recordings of a run.

    :param seed: of the run.
    :param split: train or validation.
    :raises PackingError: when again and again a crowd does not fit.
    """
    learned = split == 'train'
    purpose = Purpose.CROWDS if learned else Purpose.VALIDATION_CROWDS
    count = config.groups if learned else config.validation_groups
    return [
        record_group(config, split, seed, group, generator(seed, purpose, group))
        for group in range(count)
    ]


def record_group(
    config: CrowdsConfig, split: str, seed: int, group: int, draws: np.random.Generator
) -> Recording:
    """Return a recording of its number; one that does not fit is drawn again."""
    for attempt in range(ATTEMPTS):
        crowd = draw_crowd(config, draws)
        first = group * config.worlds
        try:
            return record(crowd, config.worlds, config.duration, split, seed, first, draws)
        except PackingError:
            if attempt == ATTEMPTS - 1:
                raise
    raise AssertionError('unreachable')
