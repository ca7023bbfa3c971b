"""What threads got of the machine's cores, as Linux counts it."""

import contextlib
from pathlib import Path

RAN, WAITED = 0, 1
"""Time on a core, and time in which a thread could run and another one did."""


def shares(*processes: int | str) -> dict[str, tuple[float, float]]:
    """Return the times of RAN and WAITED of each thread of some processes, s."""
    found = {}
    for process in processes:
        for thread in Path(f'/proc/{process}/task').iterdir():
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has ended
                ran, waited, _ = (thread / 'schedstat').read_text().split()
                found[thread.name] = int(ran) * 1e-9, int(waited) * 1e-9
    return found


def added(before: dict, after: dict, kind: int, thread: int | str | None = None) -> float:
    """
    Return what all threads, or one of them, have gained of a kind of time, s.

    :param kind: RAN or WAITED.
    :param thread: by its number, which for the first one is that of the process.
    """
    gains = {
        name: times[kind] - before.get(name, (0.0, 0.0))[kind] for name, times in after.items()
    }
    return sum(gains.values()) if thread is None else gains.get(str(thread), 0.0)
