"""Weights that a run begins with in place of random ones: those of another run."""

import dataclasses
from pathlib import Path

from torch import nn

from socialnav_core.config import Config, ConfigError
from socialnav_core.policies.loading import find_model
from socialnav_core.policies.value.checkpoint import load_checkpoint


def with_initial_weights(
    config: Config, init: str | Path | None, resume: bool
) -> tuple[Config, nn.Module | None]:
    """
    Return the configuration, which says what the run begins with, and a network of those weights.

    :param init: folder of a checkpoint or name of one in models/; None for random weights.
    :param resume: whether the run goes on from a state of its own, which holds its weights.
    :raises ConfigError: when the weights are of another network, or are not there.
    :raises CheckpointError: when the checkpoint is damaged.
    """
    settings = config.training
    if init is None:
        if settings.initial_weights and not resume:
            raise ConfigError(
                'training.initial_weights: the run began with weights of another; name their '
                'folder by --init, or leave the setting out'
            )
        return config, None
    if resume:
        raise ConfigError('--resume goes on with the weights of the run: leave --init out')
    network, other, digest = load_checkpoint(find_model(init))
    for name in ('network', 'heads', 'kinematics'):
        own, found = getattr(config.policy, name), getattr(other.policy, name)
        if own != found and (name != 'heads' or config.policy.network != 'sarl'):
            raise ConfigError(
                f'{init} has policy.{name} = {found}, not {own}; train the same by '
                f'--set policy.{name}={found}'
            )
    if settings.initial_weights not in ('', digest):
        raise ConfigError(f'{init} holds other weights than training.initial_weights names')
    begun = dataclasses.replace(settings, initial_weights=digest)
    return dataclasses.replace(config, training=begun), network
