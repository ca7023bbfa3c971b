"""Bounds of cases, each computed once and kept with the compiled kernels of the same sources."""

import dataclasses
import functools
import hashlib
import json
from pathlib import Path

import numpy as np

from socialnav_core.compilation import cache_folder, cache_is_writable
from socialnav_core.config import BoundConfig, Scenario
from socialnav_core.config.mapping import to_mapping
from socialnav_core.evaluation.bound import Bounds, bounds_of
from socialnav_core.evaluation.futures import record_futures
from socialnav_core.evaluation.run import EvaluationResult
from socialnav_core.places import PACKAGE
from socialnav_core.progress import progress_bar
from socialnav_core.storage import written_whole

TOGETHER = 64
"""Cases whose futures are recorded at a time."""
NAMES = tuple(field.name for field in dataclasses.fields(Bounds))


def find_bounds(
    scenario: Scenario,
    cases: np.ndarray,
    seed: int = 0,
    split: str = 'test',
    config: BoundConfig | None = None,
    progress: bool = False,
) -> Bounds:
    """
    Return the bounds of some cases of a scenario.

    :param cases: numbers of the cases, no two alike.
    :param progress: whether to say on stderr how it goes.
    :raises ConfigError: when people react to the robot.
    """
    config = config or BoundConfig()
    path = bounds_file(scenario, seed, split, config)
    known = read_bounds(path)
    missing = np.array([case for case in cases.tolist() if case not in known], np.int64)
    with progress_bar(len(missing), 'bound', 'case', visible=progress) as bar:
        for begin in range(0, len(missing), TOGETHER):
            some = missing[begin : begin + TOGETHER]
            found = bounds_of(record_futures(scenario, some, seed, split), config)
            columns = (getattr(found, name) for name in NAMES)
            known |= dict(zip(some.tolist(), zip(*columns, strict=True), strict=True))
            bar.update(len(some))
    if len(missing):
        write_bounds(path, known)
    rows = np.array([known[case] for case in cases.tolist()]).reshape(-1, len(NAMES))
    return Bounds(*rows.T)


def with_bounds(
    result: EvaluationResult,
    scenario: Scenario,
    config: BoundConfig | None = None,
    progress: bool = False,
) -> EvaluationResult:
    """Return a result that knows the bound of each case, for the metrics that need it."""
    cases = result.records.case_index
    bounds = find_bounds(scenario, cases, result.seed, result.split, config, progress)
    records = dataclasses.replace(
        result.records, bound=bounds.fastest, comfortable_bound=bounds.comfortable
    )
    return dataclasses.replace(result, records=records)


def bounds_file(scenario: Scenario, seed: int, split: str, config: BoundConfig) -> Path:
    """Return where the bounds of the cases of a world are kept."""
    asked = [to_mapping(scenario), seed, split, to_mapping(config), simulation_digest()]
    name = hashlib.sha256(json.dumps(asked, sort_keys=True).encode()).hexdigest()[:24]
    return cache_folder() / 'bounds' / f'{name}.npz'


@functools.cache
def simulation_digest() -> str:
    """Return the digest of the sources that say what a case is; not all of them hold kernels."""
    digest = hashlib.sha256()
    for path in sorted((PACKAGE / 'simulation').rglob('*.py')):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def read_bounds(path: Path) -> dict[int, tuple[float, ...]]:
    """Return the bounds that are known, by the numbers of the cases."""
    if not path.is_file():
        return {}
    with np.load(path) as arrays:
        columns = [arrays[name].tolist() for name in NAMES]
        return dict(zip(arrays['cases'].tolist(), zip(*columns, strict=True), strict=True))


def write_bounds(path: Path, known: dict[int, tuple[float, ...]]) -> None:
    """Keep bounds, where files can be kept; `find_bounds` is only slower where they cannot."""
    if not cache_is_writable():
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    columns = dict(zip(NAMES, np.array(list(known.values())).T, strict=True))
    with written_whole(path) as temporary:
        np.savez(temporary, cases=np.array(list(known)), **columns)
