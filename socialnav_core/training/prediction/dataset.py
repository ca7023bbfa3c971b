"""The crowds of a run, recorded anew from its seed whenever they are needed."""

import contextlib

import numpy as np

from socialnav_core.config.prediction import CrowdsConfig
from socialnav_core.simulation.layout import PackingError
from socialnav_core.training.prediction.crowds import Crowd, draw_crowd, draw_kind, record
from socialnav_core.training.prediction.recording import Recording
from socialnav_core.training.randomness import generator, Purpose

ATTEMPTS = 20
"""Crowds that are drawn, at most, until one fits into its world."""


def record_crowds(config: CrowdsConfig, seed: int, split: str) -> list[Recording]:
    """
    Return the recordings of a run.

    :param split: train or validation.
    :raises PackingError: when again and again a crowd does not fit.
    """
    learned = split == 'train'
    purpose = Purpose.CROWDS if learned else Purpose.VALIDATION_CROWDS
    count = config.groups if learned else config.validation_groups
    recordings = []
    for group in range(count):
        draws = generator(seed, purpose, group)
        kind = draw_kind(config.mixture, draws)
        recordings.append(record_fitting(kind, config, split, seed, group, draws))
    return recordings


def record_fitting(
    crowd: Crowd | str,
    config: CrowdsConfig,
    split: str,
    seed: int,
    group: int,
    draws: np.random.Generator,
) -> Recording:
    """
    Return a recording of its number; one that does not fit into its world is drawn again.

    :param crowd: itself, or its kind.
    :raises PackingError: when no attempt fits.
    """

    def attempt() -> Recording:
        drawn = draw_crowd(crowd, draws) if isinstance(crowd, str) else crowd
        first = group * config.worlds
        return record(drawn, config.worlds, config.duration, split, seed, first, draws)

    for _ in range(ATTEMPTS - 1):
        with contextlib.suppress(PackingError):
            return attempt()
    return attempt()
