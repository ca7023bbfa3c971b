"""Which cases are still to be run."""

from collections.abc import Sequence
import dataclasses
import numbers

import numpy as np

from socialnav_core.config.ranges import shown
from socialnav_core.simulation.random_streams import SPLITS

ENDLESS = -1


@dataclasses.dataclass
class CaseQueue:
    """Cases of one split and seed that are handed out once each, in order."""

    seed: int
    """0 <= seed < 2 ** 64."""
    split: str
    """train, validation or test."""
    cases: np.ndarray | None
    """What is handed out, int64 (count,); None: 0, 1, 2, ... without end."""
    taken: int = 0
    """How many have been handed out."""

    def take(self, wanted: int) -> np.ndarray:
        """Return the next cases, int64: as many as are wanted, or fewer when none is left."""
        end = self.taken + wanted
        taken = np.arange(self.taken, end) if self.cases is None else self.cases[self.taken : end]
        self.taken += len(taken)
        return taken

    def arrays(self) -> dict[str, np.ndarray]:
        """Return everything by name; a seed fills two words, so that it survives int64."""
        count = ENDLESS if self.cases is None else len(self.cases)
        numbers = (self.taken, count, SPLITS[self.split], self.seed & 0xFFFFFFFF, self.seed >> 32)
        cases = np.empty(0, np.int64) if self.cases is None else self.cases
        return {'counters': np.array(numbers, np.int64), 'cases': cases}

    @staticmethod
    def from_arrays(arrays: dict[str, np.ndarray]) -> 'CaseQueue':
        """Return the queue whose `arrays` these are; other names are left aside."""
        taken, count, split, low, high = arrays['counters'].tolist()
        cases = None if count == ENDLESS else arrays['cases'].copy()
        return CaseQueue(low | high << 32, list(SPLITS)[split], cases, taken)


def queue_of(seed: int, split: str, cases: Sequence[int] | np.ndarray | None = None) -> CaseQueue:
    """
    Return a queue of which nothing has been taken.

    :param cases: to run once each; None for 0, 1, 2, ... without end.
    :raises ValueError: for a seed, split or case that does not exist.
    """
    if isinstance(seed, bool) or not isinstance(seed, numbers.Integral):
        raise ValueError(f'seed must be a whole number, not {shown(seed)}')
    if not 0 <= seed < 2**64:
        raise ValueError(f'seed must lie in [0, 2^64), not {shown(seed)}')
    if split not in SPLITS:
        raise ValueError(f'split must be one of {", ".join(SPLITS)}, not {split!r}')
    if cases is None:
        return CaseQueue(int(seed), split, None)
    return CaseQueue(int(seed), split, checked_cases(cases))


def checked_cases(cases: Sequence[int] | np.ndarray) -> np.ndarray:
    """
    Return the numbers of cases, int64.

    :raises ValueError: for what is no list of whole numbers in [0, 2^32).
    """
    given = np.asarray(cases)
    if given.ndim != 1 or (given.size and given.dtype.kind not in 'iu'):
        raise ValueError(f'cases must be a list of whole numbers, not {shown(cases)}')
    if ((given < 0) | (given >= 2**32)).any():
        raise ValueError('cases must lie in [0, 2^32)')
    return given.astype(np.int64)
