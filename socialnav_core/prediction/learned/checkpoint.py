"""A trained prediction on disk: weights in safetensors, the resolved config beside them."""

from collections.abc import Mapping
import hashlib
import os
from pathlib import Path

import numpy as np
from safetensors import safe_open, SafetensorError
from safetensors.numpy import save

from socialnav_core.config import ConfigError
from socialnav_core.config.documents import read_yaml, told_with_place
from socialnav_core.config.mapping import from_mapping, to_yaml
from socialnav_core.config.prediction import PredictionConfig
from socialnav_core.places import MODELS
from socialnav_core.prediction.learned.layout import INPUTS, OUTPUTS
from socialnav_core.prediction.learned.predictor import LearnedPredictor
from socialnav_core.storage import (
    arrays_digest,
    atomic_write,
    canonical,
    CheckpointError,
    require_sane,
    require_weights_file,
    UNREADABLE,
)

WEIGHTS = 'prediction.safetensors'
CONFIG = 'config.yaml'


def load_predictor(model: str | Path = 'prediction') -> LearnedPredictor:
    """
    Return a predictor without history.

    :param model: the folder of a checkpoint or the name of one in models/.
    :raises ConfigError: when there is none.
    :raises CheckpointError: when it is damaged.
    """
    return LearnedPredictor(load_weights(find_predictor(model))[0])


def find_predictor(model: str | Path) -> Path:
    """Return the folder of a checkpoint, given as such or by its name in models/."""
    for folder in (Path(model), MODELS / model):
        if os.path.isfile(folder / WEIGHTS):  # no error for what cannot be a path
            return folder
    known = ', '.join(sorted(path.parent.name for path in MODELS.glob(f'*/{WEIGHTS}')))
    raise ConfigError(
        f'no learned prediction {str(model)!r}: give the folder of one{", or " * bool(known)}'
        f'{known}; socialnav train-prediction makes them'
    )


def save_weights(
    folder: Path, weights: Mapping[str, np.ndarray], config: PredictionConfig
) -> None:
    """Write weights and config; each file is replaced at once or not at all."""
    folder.mkdir(parents=True, exist_ok=True)
    text = to_yaml(config).encode()
    metadata = {
        'digest': arrays_digest(weights),
        'config_digest': hashlib.sha256(text).hexdigest(),
    }
    atomic_write(folder / CONFIG, text)
    atomic_write(folder / WEIGHTS, canonical(save(dict(weights), metadata)))


def load_weights(folder: Path) -> tuple[dict[str, np.ndarray], PredictionConfig]:
    """
    Return the weights and the config of a checkpoint.

    :raises CheckpointError: when a file is missing, damaged, altered or of another network.
    """
    path = folder / WEIGHTS
    require_weights_file(path)
    try:
        with safe_open(path, 'numpy') as file:
            metadata = file.metadata() or {}
            names = file.keys()  # the file itself cannot be iterated over
            weights = {name: file.get_tensor(name) for name in names}
        values = read_yaml(folder / CONFIG)
        with told_with_place(folder / CONFIG, {}):
            config = from_mapping(PredictionConfig, values)
        text = (folder / CONFIG).read_bytes()
    except (SafetensorError, ConfigError, *UNREADABLE) as error:
        raise CheckpointError(f'{folder} holds no learned prediction: {error}') from error
    if metadata.get('config_digest') != hashlib.sha256(text).hexdigest():
        raise CheckpointError(f'{folder / CONFIG} is altered: the weights were saved with another')
    if metadata.get('digest') != arrays_digest(weights):
        raise CheckpointError(f'{path} is altered: its digest does not match')
    found = {name: array.shape for name, array in weights.items()}
    single = all(array.dtype == np.float32 for array in weights.values())
    if found != shapes(config.training.width) or not single:
        raise CheckpointError(f'{path} does not hold the network that {CONFIG} describes')
    require_sane(weights, path)
    return weights, config


def shapes(width: int) -> dict[str, tuple[int, ...]]:
    """Return the names and shapes of the weights of a network of a width."""
    sizes = (INPUTS, width, width, width, OUTPUTS)
    layers = list(zip(sizes[1:], sizes[:-1], strict=True))
    matrices = {f'{number}.weight': layer for number, layer in enumerate(layers)}
    return matrices | {f'{number}.bias': layer[:1] for number, layer in enumerate(layers)}
