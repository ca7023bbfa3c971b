"""The state of a run in one file, from which it goes on as if it had never stopped."""

from collections.abc import Mapping
import json
from pathlib import Path
from typing import Any

import numpy as np
from safetensors import safe_open, SafetensorError
from safetensors.numpy import save
import torch

from socialnav_core.config import ConfigError, require
from socialnav_core.config.mapping import flatten, from_mapping, to_mapping
from socialnav_core.storage import (
    arrays_digest,
    atomic_write,
    canonical,
    CheckpointError,
    UNREADABLE,
)

STATE_NAME = 'training_state.safetensors'
FINISHED_NAME = 'finished_state.safetensors'
"""What the state is called once the run is as long as it should be."""
LENGTHS = ('training.iterations', 'training.episodes', 'training.updates')
ROUNDS = 'training.rounds'
"""Settings that say how long a run is, the latter where there is one; it may have more."""
FORMAT = 'socialnav training state 1'

Arrays = dict[str, np.ndarray]


def save_state(folder: Path, sections: Mapping[str, Arrays], config: Any) -> None:
    """
    Write the state of a run; whenever the process dies, the file is the old one or the new one.

    :param config: of the run, a dataclass of socialnav_core.config.
    :raises CheckpointError: when it cannot be written; the file then is the old one.
    """
    arrays = {
        f'{section}/{name}': np.asarray(array, order='C')
        for section, part in sections.items()
        for name, array in part.items()
    }
    metadata = {
        'format': FORMAT,
        'config': json.dumps(to_mapping(config)),
        'threads': str(torch.get_num_threads()),
        'digest': arrays_digest(arrays),
    }
    path = folder / STATE_NAME
    try:
        atomic_write(path, canonical(save(arrays, metadata)))
    except OSError as error:
        raise CheckpointError(
            f'{path} cannot be written ({error.strerror}); what was saved last is still there: '
            'make room and go on with --resume'
        ) from error


def load_state(folder: Path, config: Any) -> dict[str, Arrays]:
    """
    Return the arrays of each part of a run.

    :param config: must be the one that the run was started with, or of a longer run.
    :raises ConfigError: when there is nothing to resume or a setting differs.
    :raises CheckpointError: when the file is damaged.
    """
    path = state_file(folder)
    try:
        with safe_open(path, 'numpy') as file:
            metadata = file.metadata() or {}
            names = file.keys()
            arrays = {name: file.get_tensor(name) for name in names}
    except (SafetensorError, *UNREADABLE) as error:
        raise CheckpointError(f'{path} is damaged ({error}); start again') from error
    if metadata.get('format') != FORMAT or metadata.get('digest') != arrays_digest(arrays):
        raise CheckpointError(f'{path} is damaged or of another version; start again')
    threads = metadata.get('threads', '')
    try:  # settings that the saved one lacks have their defaults
        saved = to_mapping(from_mapping(type(config), json.loads(metadata.get('config', ''))))
    except ValueError as error:
        raise CheckpointError(f'{path} is damaged ({error}); start again') from error
    require_same(saved, to_mapping(config))
    if path.name == FINISHED_NAME:
        require_longer(saved, to_mapping(config))
    require(
        threads == str(torch.get_num_threads()),
        f'the run was started with {threads} processor threads, not '
        f'{torch.get_num_threads()}; resume it with as many',
    )
    sections: dict[str, Arrays] = {}
    for name, array in arrays.items():
        section, _, key = name.partition('/')
        sections.setdefault(section, {})[key] = array
    return sections


def state_file(folder: Path) -> Path:
    """
    Return the file of the state in a folder, that of a finished run where there is no other.

    :raises ConfigError: when there is none.
    """
    for name in (STATE_NAME, FINISHED_NAME):
        if (folder / name).is_file():
            return folder / name
    raise ConfigError(
        f'{folder} holds no unfinished run ({STATE_NAME}) and none that could be made longer '
        f'({FINISHED_NAME}); leave --resume out, or start again with --overwrite'
    )


def lengths(settings: Mapping[str, Any]) -> tuple[str, ...]:
    """Return which of the settings of a run say how long it is."""
    return (ROUNDS,) if ROUNDS in settings else LENGTHS


def require_longer(saved: Mapping[str, Any], given: Mapping[str, Any]) -> None:
    """Raise a ConfigError unless a finished run is asked to be longer than it is."""
    old, new = flatten(saved), flatten(given)
    # iterations count for nothing where the length is given in episodes
    name = next(name for name in reversed(lengths(old)) if old.get(name))
    if old[name] == new[name]:
        raise ConfigError(
            f'the run is finished after {name} = {old[name]}; make it longer by a greater one, '
            f'such as --set {name}={2 * old[name]}'
        )


def require_same(saved: Mapping[str, Any], given: Mapping[str, Any]) -> None:
    """
    Raise a ConfigError that names the first setting in which two configurations differ.

    A greater length is no difference.
    """
    old, new = flatten(saved), flatten(given)
    for name in sorted(old.keys() | new.keys()):
        if name in lengths(old) and 0 < (old.get(name) or 0) < (new.get(name) or 0):
            continue
        if old.get(name) != new.get(name):
            raise ConfigError(
                f'the run was started with {name} = {old.get(name)!r}, not {new.get(name)!r}; '
                'resume it with its own config.yaml or start another with another --out'
            )


def network_arrays(network: torch.nn.Module) -> Arrays:
    """Return the parameters by name."""
    return {name: tensor.cpu().numpy() for name, tensor in network.state_dict().items()}


def restore_network(network: torch.nn.Module, arrays: Arrays) -> None:
    """
    Set the parameters in place.

    :param arrays: from network_arrays of a module of the same kind.
    """
    network.load_state_dict({name: torch.from_numpy(array) for name, array in arrays.items()})


def optimizer_arrays(optimizer: torch.optim.Optimizer) -> Arrays:
    """
    Return what the optimizer remembers of each parameter: moments or momentum.

    :param optimizer: before its first step it remembers nothing.
    """
    return {
        f'{index}/{name}': tensor.cpu().numpy()
        for index, moments in optimizer.state_dict()['state'].items()
        for name, tensor in moments.items()
        if tensor is not None
    }


def restore_optimizer(optimizer: torch.optim.Optimizer, arrays: Arrays) -> None:
    """
    Set what the optimizer remembers, in place.

    :param optimizer: of parameters of the same shapes.
    :param arrays: from optimizer_arrays.
    """
    state: dict[int, dict[str, torch.Tensor]] = {}
    for key, array in arrays.items():
        index, _, name = key.partition('/')
        state.setdefault(int(index), {})[name] = torch.from_numpy(array)
    groups = optimizer.state_dict()['param_groups']
    optimizer.load_state_dict({'state': state, 'param_groups': groups})
