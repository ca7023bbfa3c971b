"""What a trained run did in some cases, kept beside it and never measured twice."""

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np

from socialnav_core.evaluation.metrics import COLLISIONS
from socialnav_core.policies.checkpoint import atomic_write, checkpoint_digest
from socialnav_core.simulation import Outcome

FOLDER = 'evaluations'
LOOKAHEADS = ('oracle', 'constant_velocity')


@dataclasses.dataclass(frozen=True)
class Cases:
    """Cases 0 to episodes - 1 of seed 0, and how the policy looks ahead in them."""

    scenario: str
    lookahead: str
    split: str = 'test'
    episodes: int = 500

    @property
    def name(self) -> str:
        """Return the name of the file of a measurement, without its ending."""
        what = '' if (self.split, self.episodes) == ('test', 500) else (
            f'-{self.split}-{self.episodes}'
        )  # fmt: skip
        return f'{self.scenario}-{self.lookahead}{what}'

    def path(self, run: Path) -> Path:
        """
        Return the file of a measurement.

        :param run: folder of the run.
        """
        return run / FOLDER / f'{self.name}.json'


@dataclasses.dataclass(frozen=True)
class Measurement:
    """How the cases of one run ended."""

    cases: Cases
    """Which cases, in what order."""
    outcome: np.ndarray
    """Codes of Outcome, (cases,)."""
    time: np.ndarray
    """When they ended, s, (cases,)."""
    summary: dict[str, Any]
    """As `socialnav evaluate --json` writes it, without the single cases."""

    @property
    def success(self) -> np.ndarray:
        """Return which cases ended at the goal, bool (cases,)."""
        return self.outcome == Outcome.GOAL

    @property
    def collision(self) -> np.ndarray:
        """Return which cases ended at an agent or outside of the walls, bool (cases,)."""
        return np.isin(self.outcome, COLLISIONS)

    @property
    def timeout(self) -> np.ndarray:
        """Return which cases ran out of time, bool (cases,)."""
        return self.outcome == Outcome.TIMEOUT

    @property
    def navigation_time(self) -> np.ndarray:
        """Return the times of successes, NaN elsewhere, s, (cases,)."""
        return np.where(self.success, self.time, np.nan)


def evaluate_arguments(run: Path, cases: Cases) -> list[str]:
    """
    Return the arguments of socialnav that measure a run.

    :param run: folder of the run.
    :param cases: which ones.
    """
    return [
        'evaluate', str(run), '--scenario', cases.scenario, '--episodes', str(cases.episodes),
        '--seed', '0', '--split', cases.split, '--lookahead', cases.lookahead, '--no-screening',
        '--json', str(raw_path(run, cases)), '--overwrite',
    ]  # fmt: skip


def raw_path(run: Path, cases: Cases) -> Path:
    """
    Return the file that `socialnav evaluate` writes before it is kept.

    :param run: folder of the run.
    :param cases: which ones.
    """
    return cases.path(run).with_suffix('.part')


def keep(run: Path, cases: Cases) -> None:
    """
    Keep what `socialnav evaluate` has written, together with the digest of the weights.

    :param run: folder of the run.
    :param cases: which ones.
    """
    raw = raw_path(run, cases)
    summary = json.loads(raw.read_text(encoding='utf-8'))
    episodes = summary.pop('cases')
    values = {
        'weights': checkpoint_digest(run),
        'summary': summary,
        'outcome': [episode['outcome'] for episode in episodes],
        'time': [episode['time'] for episode in episodes],
    }
    atomic_write(cases.path(run), json.dumps(values).encode())
    raw.unlink()


def load(run: Path, cases: Cases) -> Measurement | None:
    """
    Return the measurement of a run, None where there is none of its present weights.

    :param run: folder of the run.
    :param cases: which ones.
    """
    path = cases.path(run)
    if not path.is_file():
        return None
    values = json.loads(path.read_text(encoding='utf-8'))
    if values['weights'] != checkpoint_digest(run):
        return None
    codes = [Outcome[name.upper()] for name in values['outcome']]
    return Measurement(
        cases, np.array(codes, np.int8), np.array(values['time']), values['summary']
    )
