"""What a trained run did in some cases, kept beside it and never measured twice."""

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np

from socialnav_core.metrics import COLLISIONS
from socialnav_core.policies.value.checkpoint import checkpoint_digest
from socialnav_core.simulation import Outcome
from socialnav_core.storage import atomic_write
from socialnav_core.training.folder import UNFOLDED

FOLDER = 'evaluations'
LOOKAHEADS = ('oracle', 'constant_velocity')


@dataclasses.dataclass(frozen=True)
class Cases:
    """Cases 0 to episodes - 1 of seed 0, and how the policy looks ahead in them."""

    scenario: str
    lookahead: str
    split: str = 'test'
    episodes: int = 500
    unfolded: bool = False
    """Whether the weights are those of training, constant features not folded into the biases."""

    @property
    def name(self) -> str:
        """Return the name of the file of a measurement, without its ending."""
        standard = (self.split, self.episodes) == ('test', 500)
        which = '' if standard else f'-{self.split}-{self.episodes}'
        return f'{self.scenario}-{self.lookahead}{which}{"-unfolded" if self.unfolded else ""}'

    def path(self, run: Path) -> Path:
        """Return the file of a measurement."""
        return run / FOLDER / f'{self.name}.json'

    def checkpoint(self, run: Path) -> Path:
        """Return the folder of the weights that are measured."""
        return run / UNFOLDED if self.unfolded else run


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
    """Return the arguments of socialnav that measure a run."""
    return [
        'evaluate', str(cases.checkpoint(run)), '--scenario', cases.scenario,
        '--episodes', str(cases.episodes), '--seed', '0', '--split', cases.split,
        '--lookahead', cases.lookahead, '--no-screening',
        '--json', str(raw_path(run, cases)), '--overwrite',
    ]  # fmt: skip


def raw_path(run: Path, cases: Cases) -> Path:
    """Return the file that `socialnav evaluate` writes before it is kept."""
    return cases.path(run).with_suffix('.part')


def keep(run: Path, cases: Cases) -> None:
    """Keep what `socialnav evaluate` has written, together with the digest of the weights."""
    raw = raw_path(run, cases)
    summary = json.loads(raw.read_text(encoding='utf-8'))
    episodes = summary.pop('cases')
    values = {
        'weights': checkpoint_digest(cases.checkpoint(run)),
        'summary': summary,
        'outcome': ''.join(str(Outcome[each['outcome'].upper()].value) for each in episodes),
        'time': [each['time'] for each in episodes],
    }
    atomic_write(cases.path(run), json.dumps(values).encode())
    raw.unlink()


def load(run: Path, cases: Cases) -> Measurement | None:
    """Return the measurement of a run, None where there is none of its present weights."""
    values = values_of(run, cases)
    return None if values is None else from_values(cases, values)


def values_of(run: Path, cases: Cases) -> dict[str, Any] | None:
    """Return what a measurement's file holds, None where none is of the present weights."""
    path = cases.path(run)
    if not path.is_file():
        return None
    values: dict[str, Any] = json.loads(path.read_text(encoding='utf-8'))
    return values if values['weights'] == checkpoint_digest(cases.checkpoint(run)) else None


def from_values(cases: Cases, values: dict[str, Any]) -> Measurement:
    """Return a measurement from the contents of its file."""
    codes = np.array([int(code) for code in values['outcome']], np.int8)
    return Measurement(cases, codes, np.array(values['time']), values['summary'])
