"""Random streams that need no memory: the same key gives the same numbers, in any order."""

import enum

import numpy as np
import torch
from torch import nn

from socialnav_core.config import PolicyConfig
from socialnav_core.policies import build_network


class Purpose(enum.IntEnum):
    """What a stream is for; one purpose's draws never move another's."""

    IMITATION = 1
    SELECTION = 2
    EXPLORATION = 3
    REPLAY = 4
    BUCKET = 5
    CROWDS = 6
    VALIDATION_CROWDS = 7
    EXAMPLES = 8
    VALIDATION_EXAMPLES = 9
    EVALUATION_CROWDS = 10
    PLANNER_WORLDS = 11
    PLANNER_VALIDATION = 12
    PLANNER_BATCHES = 13
    MIXED_WORLDS = 14
    MIXED_RADII = 15


def generator(seed: int, purpose: Purpose, iteration: int = 0) -> np.random.Generator:
    """
    Return a stream keyed by its arguments (Philox; Salmon et al. 2011).

    :param iteration: round of the training that uses them.
    """
    return np.random.Generator(np.random.Philox(key=[seed, purpose], counter=[0, 0, 0, iteration]))


def initial_network(config: PolicyConfig, seed: int) -> nn.Module:
    """Return a value network with random weights, leaving torch's own generator as it was."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        return build_network(config)
