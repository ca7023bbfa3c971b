"""A run so small that it takes a second or two."""

import pytest
import torch

from socialnav_core.config.reading import read_config

torch.set_num_threads(1)  # more make small networks slower, and other weights

TINY = {
    'name': 'tiny',
    'scenario.time_limit': 14.0,
    'scenario.pedestrians': 2,
    'scenario.obstacles': 2,
    'training.worlds': 4,
    'training.iterations': 4,
    'training.steps_per_iteration': 6,
    'training.updates_per_iteration': 2,
    'training.batch_size': 16,
    'training.replay_capacity': 300,
    'training.checkpoint_iterations': 1,
    'training.imitation.episodes': 5,
    'training.imitation.epochs': 1,
    'training.imitation.batch_size': 32,
}


@pytest.fixture
def tiny_config():
    """Return the configuration of a tiny run."""
    return read_config('sarl', TINY)
