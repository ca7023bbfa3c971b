"""How far something has come, on stderr: a bar on a terminal, elsewhere a line a minute."""

import os
import sys
import time
from typing import Any

PERIOD = 60.0
"""Time between two lines where there is no terminal, s."""
COLUMNS, ROWS = 80, 24
"""Size that a terminal is taken to have that does not say how large it is."""


def progress_bar(
    total: int, description: str, unit: str = 'episode', initial: int = 0, visible: bool = True
) -> Any:
    """
    Return what shows progress: a context with `update` and `set_postfix_str`, as tqdm has them.

    :param initial: units that were done before.
    """
    terminal = sys.stderr.isatty()
    if visible and not terminal:
        return ProgressLines(total, description, unit, initial)
    from tqdm import tqdm

    # tqdm fits itself to the terminal, and shows nothing on a pseudo-terminal that says 0 by 0
    sized = terminal and os.get_terminal_size(sys.stderr.fileno()).columns > 0
    return tqdm(
        total=total, desc=description, unit=unit, initial=initial, leave=False,
        dynamic_ncols=sized, ncols=None if sized else COLUMNS,
        nrows=None if sized else ROWS, disable=not visible,
    )  # fmt: skip


class ProgressLines:
    """Says on stderr once a minute how far something has come."""

    def __init__(self, total: int, description: str, unit: str, initial: int) -> None:
        """Begin at `initial`; the first line comes after a minute."""
        self.total, self.description, self.unit, self.done = total, description, unit, initial
        self.remark = ''
        self._said = self._started = time.monotonic()

    def __enter__(self) -> 'ProgressLines':
        """Return itself."""
        return self

    def __exit__(self, *error: object) -> None:
        """End; nothing is left to do."""

    def set_postfix_str(self, remark: str) -> None:
        """Add a remark to the lines from now on."""
        self.remark = f', {remark}'

    def update(self, count: int = 1) -> None:
        """Count units that were done, and say so when a minute has passed."""
        self.done += count
        now = time.monotonic()
        if now - self._said < PERIOD:
            return
        self._said = now
        units = self.unit if self.total == 1 or self.unit.endswith('s') else f'{self.unit}s'
        minutes = (now - self._started) / 60
        print(
            f'{self.description}: {self.done} of {self.total} {units} after {minutes:.0f} min'
            f'{self.remark}', file=sys.stderr, flush=True,
        )  # fmt: skip

    def close(self) -> None:
        """End; nothing is left to do."""
