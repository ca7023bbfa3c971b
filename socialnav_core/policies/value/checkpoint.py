"""A checkpoint on disk: weights in safetensors, the resolved config beside them."""

import hashlib
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from safetensors import safe_open, SafetensorError
from safetensors.torch import save
import torch
from torch import nn

from socialnav_core.config import Config, ConfigError, PolicyConfig
from socialnav_core.config.documents import read_yaml, told_with_place
from socialnav_core.config.mapping import from_mapping, to_yaml
from socialnav_core.policies.value.gat4sn import Gat4snValueNetwork
from socialnav_core.policies.value.sarl import SarlValueNetwork
from socialnav_core.storage import (
    atomic_write,
    canonical,
    CheckpointError,
    require_sane,
    require_weights_file,
    UNREADABLE,
)

Settings = TypeVar('Settings', bound=Any)

WEIGHTS = 'weights.safetensors'
CONFIG = 'config.yaml'
ATTENTION_SCORES = {'gat4sn': 'gat', 'gat4sn_linear': 'linear', 'gat4sn_v2': 'gatv2'}


class Checkpoint(NamedTuple):
    """What a checkpoint holds."""

    network: nn.Module
    """In evaluation mode, on the CPU."""
    config: Config
    """Of the run that made it."""
    digest: str
    """Of the weights, hexadecimal; see `tensors_digest`."""


def build_network(config: PolicyConfig) -> nn.Module:
    """Return the value network of a policy, drawn from torch's global generator."""
    if config.network == 'sarl':
        return SarlValueNetwork()
    return Gat4snValueNetwork(config.heads, ATTENTION_SCORES[config.network])


def save_weights(folder: Path, network: nn.Module, config: Config) -> None:
    """
    Write weights and config; each file is replaced at once or not at all.

    :param folder: made if needed.
    """
    write_tensors(folder, WEIGHTS, network, to_yaml(config))


def write_tensors(folder: Path, name: str, network: nn.Module, config: str) -> None:
    """
    Write the weights of a network under a name, and the text of a config beside them.

    :param folder: made if needed.
    """
    folder.mkdir(parents=True, exist_ok=True)
    text = config.encode()
    tensors = {
        name: value.detach().cpu().contiguous() for name, value in network.state_dict().items()
    }
    metadata = {
        'digest': tensors_digest(tensors),
        'config_digest': hashlib.sha256(text).hexdigest(),
    }
    atomic_write(folder / CONFIG, text)
    atomic_write(folder / name, canonical(save(tensors, metadata)))


def load_checkpoint(folder: Path) -> Checkpoint:
    """
    Return what a checkpoint holds.

    :raises CheckpointError: when a file is missing, damaged, altered or does not fit the config.
    """
    if not folder.is_dir():
        raise CheckpointError(f'no checkpoint folder {folder}')
    tensors, metadata = read_tensors(folder / WEIGHTS)
    config = read_config(folder / CONFIG, metadata, Config)
    network = build_network(config.policy)
    digest = fill_network(network, tensors, metadata, folder / WEIGHTS, config.policy.network)
    return Checkpoint(network.eval(), config, digest)


def fill_network(
    network: nn.Module,
    tensors: dict[str, torch.Tensor],
    metadata: dict[str, str],
    path: Path,
    kind: str,
) -> str:
    """
    Give a network its weights and return their digest.

    :param path: of the weights, for messages.
    :param kind: of the network, as the config names it.
    :raises CheckpointError: when they are altered, of another network or not finite.
    """
    digest = tensors_digest(tensors)
    if metadata.get('digest') != digest:
        raise CheckpointError(f'{path} is altered: its digest does not match')
    expected = {name: (v.shape, v.dtype) for name, v in network.state_dict().items()}
    found = {name: (v.shape, v.dtype) for name, v in tensors.items()}
    if expected != found:
        differing = sorted(
            name for name in expected.keys() | found if expected.get(name) != found.get(name)
        )
        raise CheckpointError(
            f'{path} does not hold the network {kind} that '
            f'{CONFIG} names: {differing[0]} is missing, unknown or of another shape or type'
        )
    require_sane({name: value.numpy() for name, value in tensors.items()}, path)
    network.load_state_dict(tensors)
    return digest


def read_config(path: Path, metadata: dict[str, str], kind: type[Settings]) -> Settings:
    """
    Return the config of a checkpoint, unaltered since the weights were written.

    :param metadata: of the weights.
    :param kind: dataclass of the config.
    :raises CheckpointError: when it is missing, altered or holds no such config.
    """
    try:
        values = read_yaml(path)
        with told_with_place(path, {}):
            config = from_mapping(kind, values)
        text = path.read_bytes()
    except (OSError, ConfigError) as error:
        raise CheckpointError(f'not the config of a checkpoint: {error}') from error
    if metadata.get('config_digest') != hashlib.sha256(text).hexdigest():
        raise CheckpointError(
            f'{path} is altered: it is not the one that the weights were saved with'
        )
    return config


def read_tensors(path: Path) -> tuple[dict[str, torch.Tensor], dict[str, str]]:
    """
    Return the tensors and the metadata of a safetensors file.

    :raises CheckpointError: when it is missing or no complete safetensors file.
    """
    require_weights_file(path)
    try:
        with safe_open(path, framework='pt') as file:
            names = file.keys()  # the file itself cannot be iterated over
            tensors = {name: file.get_tensor(name) for name in names}
            return tensors, file.metadata() or {}
    except (SafetensorError, *UNREADABLE) as error:
        raise CheckpointError(f'{path} cannot be read as weights: {error}') from error


def checkpoint_digest(folder: Path) -> str:
    """
    Return the digest of the weights of a checkpoint, hexadecimal.

    :raises CheckpointError: when the weights cannot be read.
    """
    return tensors_digest(read_tensors(folder / WEIGHTS)[0])


def tensors_digest(tensors: dict[str, torch.Tensor]) -> str:
    """Return the SHA-256 of names, types, shapes and values, hexadecimal."""
    digest = hashlib.sha256()
    for name in sorted(tensors):
        value = tensors[name]
        digest.update(f'{name} {value.dtype} {tuple(value.shape)}'.encode())
        flat = value.contiguous().reshape(-1)  # a number without axes has no bytes to view
        digest.update(flat.view(torch.uint8).numpy().tobytes())
    return digest.hexdigest()
