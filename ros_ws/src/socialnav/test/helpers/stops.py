"""How soon robots were stopped, for the summary of all tests."""

from collections import defaultdict
import statistics

INPUT_TIMEOUT, PERIOD = 0.5, 0.1
"""Defaults of the policy node, s."""
ALLOWANCE = 0.15
"""What a busy machine may add, s."""
LIMIT = INPUT_TIMEOUT + PERIOD + ALLOWANCE

times: dict[str, list[float]] = defaultdict(list)
"""Times from a fault to the first zero command, s, by the fault."""
measured: list[str] = []
"""Tables of measurements that run as programs of their own."""


def note(fault: str, duration: float, limit: float = LIMIT) -> None:
    """Keep the time of a stop; fail where it was too long."""
    times[fault].append(duration)
    assert duration <= limit, f'{fault}: stopped after {duration:.2f} s, not {limit:.2f} s'


def table() -> list[str]:
    """Return all stops as lines of a table; none where nothing was stopped."""
    rows = [
        f'| {fault} | {len(some)} | {statistics.median(some):.2f} s | {max(some):.2f} s |'
        for fault, some in sorted(times.items())
    ]
    return ['| fault | times | median | longest |', '|---|---|---|---|', *rows] if rows else []
