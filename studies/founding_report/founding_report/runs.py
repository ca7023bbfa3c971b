"""A training run of one row and seed: its folder, its command and whether it is finished."""

import dataclasses
import os
from pathlib import Path
import platform
import shutil
from typing import Any

import torch
import yaml

from founding_report.rows import Row
from socialnav_core.config import Config, ConfigError
from socialnav_core.config.mapping import flatten, to_mapping
from socialnav_core.policies.value.checkpoint import (
    atomic_write,
    checkpoint_digest,
    WEIGHTS,
)
from socialnav_core.training.model_card import CARD_NAME, last_row
from socialnav_core.training.progress import CSV_NAME
from socialnav_core.training.resume import STATE_NAME

MACHINE = 'machine.yaml'
MACHINE_SETTINGS = ('training.bfloat16', 'training.device')
"""Settings that depend on where a run was trained."""


@dataclasses.dataclass(frozen=True)
class Training:
    """How a run went."""

    weights: str
    """Digest of what it left."""
    progress: dict[str, float]
    """Last row of its progress."""
    machine: dict[str, Any]
    """Where it was trained, empty where that was not noted."""


def training_of(folder: Path) -> Training:
    """Return how a finished run went."""
    return Training(checkpoint_digest(folder), last_row(folder / CSV_NAME), machine_of(folder))


def is_finished(folder: Path) -> bool:
    """Return whether a run is trained."""
    complete = all((folder / name).is_file() for name in (WEIGHTS, CARD_NAME))
    return complete and not (folder / STATE_NAME).exists()


def train_arguments(row: Row, seed: int, folder: Path, quick: bool, device: str) -> list[str]:
    """
    Return the arguments of socialnav that train a run or go on with it.

    :param folder: of the run; what is left in it of a run that saved nothing is removed.
    :param quick: whether to train for seconds only.
    :param device: cpu or cuda.
    """
    resumable = (folder / STATE_NAME).is_file()
    if not resumable:
        shutil.rmtree(folder, ignore_errors=True)
    assignments = row.assignments(quick) | {'training.device': device}
    return [
        'train', row.config, '--seed', str(seed), '--out', str(folder),
        *(['--resume'] if resumable else []), '--set', *assignment_texts(assignments),
    ]  # fmt: skip


def assignment_texts(assignments: dict[str, Any]) -> list[str]:
    """
    Return settings as they are typed after `--set`.

    :param assignments: dotted names and values.
    """
    return [
        f'{key}={yaml.safe_dump(value, default_flow_style=True).split(chr(10))[0]}'
        for key, value in assignments.items()
    ]


def require_same_settings(row: Row, seed: int, found: Config, quick: bool, where: Path) -> None:
    """
    Raise a ConfigError when a run has other settings than its row has now.

    :param where: its folder or record.
    """
    settings = flatten(to_mapping(found))
    for name, value in flatten(to_mapping(row.resolved(seed, quick))).items():
        if name not in MACHINE_SETTINGS and settings.get(name) != value:
            raise ConfigError(
                f'{where} was trained with {name} = {settings.get(name)!r}, not {value!r}; move '
                'it away and it is trained again'
            )


def note_machine(folder: Path, device: str, jobs: int) -> None:
    """
    Write beside a run where it was trained.

    :param jobs: processes side by side.
    """
    name = torch.cuda.get_device_name() if device == 'cuda' else platform.machine()
    values = {
        'device': device, 'name': name, 'jobs': jobs, 'processors': os.cpu_count(),
        'python': platform.python_version(), 'torch': str(torch.__version__),
    }  # fmt: skip
    atomic_write(folder / MACHINE, yaml.safe_dump(values, sort_keys=False).encode())


def machine_of(folder: Path) -> dict[str, Any]:
    """Return where a run was trained, empty where that was not noted."""
    path = folder / MACHINE
    return yaml.safe_load(path.read_text(encoding='utf-8')) if path.is_file() else {}
