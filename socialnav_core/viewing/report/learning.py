"""How a model learned: the columns of the progress.csv in its folder."""

import csv
import dataclasses
import math
from pathlib import Path

from socialnav_core.config import ConfigError

PROGRESS = 'progress.csv'
STEPS = {'decisions': 'decisions', 'iteration': 'iterations', 'round': 'rounds'}
"""Columns that say how far a training is, and what they count; the first that is there is used."""
RATE = 'success_rate'


@dataclasses.dataclass(frozen=True)
class Curve:
    """Success of a model while it was trained."""

    model: str
    """Its name."""
    counts: str
    """What the steps are."""
    steps: list[float]
    """How far the training was."""
    success: list[float]
    """Share of the episodes of the training that reached their goal."""


def learning_curve(model: str, folder: Path) -> Curve | None:
    """
    Return the curve in the folder of a model; None without a file that tells of success.

    :raises ConfigError: when the file is no table.
    """
    path = folder / PROGRESS
    if not path.is_file():
        return None
    try:
        with path.open(newline='', encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
    except (UnicodeDecodeError, csv.Error) as error:
        raise ConfigError(f'{path} is no table of a training: move it away') from error
    column = next((name for name in STEPS if rows and name in rows[0]), None)
    if column is None or RATE not in rows[0]:
        return None
    points = [(number(row[column]), number(row[RATE])) for row in rows]
    kept = [point for point in points if all(map(math.isfinite, point))]
    return Curve(model, STEPS[column], *map(list, zip(*kept, strict=True))) if kept else None


def number(text: str | None) -> float:
    """Return the number that a cell holds, NaN where it holds none."""
    try:
        return float(text or 'nan')
    except ValueError:
        return math.nan
