"""A planner on disk: the weights of its value network, its resolved config beside them."""

from pathlib import Path
from typing import NamedTuple

from torch import nn

from socialnav_core.config.mapping import to_yaml
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.config.policy import PolicyConfig
from socialnav_core.policies.value.checkpoint import (
    build_network,
    CONFIG,
    fill_network,
    read_config,
    read_tensors,
    write_tensors,
)

PLANNER = 'planner.safetensors'
"""The weights; by their name a folder is known to hold a planner."""


class Planner(NamedTuple):
    """What the checkpoint of a planner holds."""

    network: nn.Module
    """In evaluation mode, on the CPU."""
    config: PlannerConfig
    """Of the run that made it."""
    digest: str
    """Of the weights, hexadecimal; see `tensors_digest`."""


def save_planner(folder: Path, network: nn.Module, config: PlannerConfig) -> None:
    """
    Write weights and config; each file is replaced at once or not at all.

    :param folder: made if needed.
    """
    write_tensors(folder, PLANNER, network, to_yaml(config))


def load_planner(folder: Path) -> Planner:
    """
    Return what a checkpoint holds.

    :raises CheckpointError: when a file is missing, damaged, altered or does not fit the config.
    """
    tensors, metadata = read_tensors(folder / PLANNER)
    config = read_config(folder / CONFIG, metadata, PlannerConfig)
    network = build_network(PolicyConfig(network=config.network, heads=config.heads))
    digest = fill_network(network, tensors, metadata, folder / PLANNER, config.network)
    return Planner(network.eval(), config, digest)
