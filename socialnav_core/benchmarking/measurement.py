"""What a benchmark reports, and how time is taken."""

from collections.abc import Callable
import dataclasses
import time
from typing import Any

import numpy as np


@dataclasses.dataclass(frozen=True)
class Measurement:
    """One figure, and the same of the reference where there is one."""

    name: str
    """What was measured."""
    value: float
    """The figure."""
    unit: str
    """Its unit."""
    reference: float | None = None
    """The same figure of the reference, measured in turns with ours."""
    ratio: float | None = None
    """How many times faster we are."""
    details: dict[str, Any] = dataclasses.field(default_factory=dict)
    """Other figures, by name."""


def calls_per_second(function: Callable[[], object], seconds: float) -> float:
    """Return how often a function can be called per second, after one call to warm up."""
    function()
    calls, started = 0, time.perf_counter()
    while (elapsed := time.perf_counter() - started) < seconds:
        function()
        calls += 1
    return calls / elapsed


def in_turns(
    ours: Callable[[], float], reference: Callable[[], float] | None, rounds: int
) -> tuple[float, float | None, float | None]:
    """
    Measure both in turns, so that a machine that slows down does so for both.

    Return the median of ours, of the reference and of the ratios ours / reference.

    :param reference: measures the reference; None where there is none.
    """
    pairs = [(ours(), reference() if reference else np.nan) for _ in range(rounds)]
    first, second = np.array(pairs).T
    if reference is None:
        return float(np.median(first)), None, None
    return float(np.median(first)), float(np.median(second)), float(np.median(first / second))
