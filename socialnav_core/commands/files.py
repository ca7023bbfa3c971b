"""Files that commands write: never by accident over another, never in part."""

import argparse
import json
import os
from pathlib import Path
from typing import Any

from socialnav_core.config import ConfigError
from socialnav_core.places import CHECKOUT, MODELS

PICTURES = ('.png', '.svg', '.pdf')
"""Suffixes of pictures."""


def require_new(path: Path | None, given: argparse.Namespace) -> None:
    """
    Raise a ConfigError unless a file can be written that does not exist or may be replaced.

    :param path: None for no file.
    """
    if path is None:
        return
    if path.is_dir():
        raise ConfigError(f'{path} is a folder; name a file in it')
    if path.exists() and not given.overwrite:
        raise ConfigError(f'{path} exists; replace it by --overwrite or name another file')
    parent = next(folder for folder in path.absolute().parents if folder.exists())
    if not parent.is_dir() or not os.access(parent, os.W_OK):
        raise ConfigError(f'{path} cannot be written: no right to write to {parent}')


def require_picture(path: Path | None, given: argparse.Namespace) -> None:
    """Raise a ConfigError unless a picture can be written; None for no picture."""
    require_new(path, given)
    if path is not None and path.suffix not in PICTURES:
        raise ConfigError(f'{path} must end in {", ".join(PICTURES[:-1])} or {PICTURES[-1]}')


def require_own(model: Path) -> None:
    """Raise a ConfigError when a model belongs to an installed package, which stays as it is."""
    if CHECKOUT is None and model.resolve().is_relative_to(MODELS):
        raise ConfigError(f'{model} belongs to the installed package: copy it and name the copy')


def write_json(path: Path | None, values: Any) -> None:
    """
    Write plain values, at once or not at all.

    :param path: of the file, whose folder is made if needed; None for no file.
    """
    from socialnav_core.storage import atomic_write

    if path is None:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    atomic_write(path, f'{json.dumps(values, indent=2, allow_nan=False)}\n'.encode())
