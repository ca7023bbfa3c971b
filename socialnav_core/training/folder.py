"""The folder of a run: who may write to it, and what is left in the end."""

from collections.abc import Iterator
import contextlib
from pathlib import Path

from socialnav_core.config import ConfigError
from socialnav_core.policies.search.checkpoint import PLANNER
from socialnav_core.policies.value.checkpoint import CONFIG, WEIGHTS
from socialnav_core.prediction.learned.checkpoint import WEIGHTS as PREDICTION
from socialnav_core.training.lock import locked
from socialnav_core.training.model_card import CARD_NAME, METRICS_NAME
from socialnav_core.training.progress import CSV_NAME, EVENTS
from socialnav_core.training.resume import FINISHED_NAME, STATE_NAME

RUN_FILES = (
    STATE_NAME, FINISHED_NAME, CSV_NAME, WEIGHTS, PREDICTION, PLANNER, CONFIG,
    METRICS_NAME, CARD_NAME,
)  # fmt: skip
MARKS = (STATE_NAME, CSV_NAME, WEIGHTS, PREDICTION, PLANNER)
UNFOLDED = 'unfolded'
"""Checkpoint with the weights as they were trained, inside the folder of the run."""


@contextlib.contextmanager
def own_folder(folder: Path, resume: bool, overwrite: bool) -> Iterator[None]:
    """
    Prepare the folder of a run, see `prepare_folder`, and keep others from training in it.

    :raises ConfigError: also when another training has it.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unusable(folder, error) from error
    with locked(folder):
        prepare_folder(folder, resume, overwrite)
        yield


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
        raise unusable(folder, error) from error


def unusable(folder: Path, error: OSError) -> ConfigError:
    """Return the error for a folder that cannot be made or written to."""
    return ConfigError(f'{folder} cannot be used ({error.strerror}); choose another --out')


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
    """Put the state aside: the run is finished, and can be made longer."""
    (folder / STATE_NAME).replace(folder / FINISHED_NAME)
