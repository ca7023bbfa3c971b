"""The folder of a run: who may write to it, and what is left in the end."""

from pathlib import Path

from socialnav_core.config import ConfigError
from socialnav_core.policies.search.checkpoint import PLANNER
from socialnav_core.policies.value.checkpoint import CONFIG, WEIGHTS
from socialnav_core.prediction.learned.checkpoint import WEIGHTS as PREDICTION
from socialnav_core.training.model_card import CARD_NAME, METRICS_NAME
from socialnav_core.training.progress import CSV_NAME
from socialnav_core.training.resume import STATE_NAME

RUN_FILES = (STATE_NAME, CSV_NAME, WEIGHTS, PREDICTION, PLANNER, CONFIG, METRICS_NAME, CARD_NAME)
MARKS = (STATE_NAME, CSV_NAME, WEIGHTS, PREDICTION, PLANNER)
EVENTS = 'events.out.tfevents.*'
UNFOLDED = 'unfolded'
"""Checkpoint with the weights as they were trained, inside the folder of the run."""


def prepare_folder(folder: Path, resume: bool, overwrite: bool) -> None:
    """
    Make the folder of a run, or empty it of an earlier run when that is wished.

    Files that no run wrote are left alone.

    :raises ConfigError: when it holds anything and neither is wished, or cannot be written.
    """
    if resume and overwrite:
        raise ConfigError('--resume and --overwrite exclude each other')
    try:
        folder.mkdir(parents=True, exist_ok=True)
        used = any(folder.iterdir())
        if used and not resume:
            require_replaceable(folder, overwrite)
        remove_files(folder, [f'.{name}.*' for name in RUN_FILES])  # of writes that were killed
        if not resume:
            remove_files(folder, [*RUN_FILES, EVENTS])
            remove_files(folder / UNFOLDED, [WEIGHTS, CONFIG])
    except OSError as error:
        raise ConfigError(
            f'{folder} cannot be used ({error.strerror}); choose another --out'
        ) from error


def require_replaceable(folder: Path, overwrite: bool) -> None:
    """Raise a ConfigError unless a folder holds a run that may be replaced."""
    if not overwrite:
        raise ConfigError(
            f'{folder} is not empty; go on with its run by --resume, replace it by --overwrite, '
            'or choose another --out'
        )
    if not any((folder / name).exists() for name in MARKS):
        raise ConfigError(f'{folder} holds no run but other files; choose another --out')


def remove_files(folder: Path, patterns: list[str]) -> None:
    """Remove files."""
    for pattern in patterns:
        for path in folder.glob(pattern):
            path.unlink()


def finish_folder(folder: Path) -> None:
    """Remove what only an unfinished run needs."""
    (folder / STATE_NAME).unlink(missing_ok=True)
