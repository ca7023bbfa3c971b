"""How punctual commands are: how long after their tick, and on how old inputs."""

from collections import deque
from collections.abc import Mapping

import numpy as np

from socialnav.control.inputs import AGEING

WINDOW = 1000
"""Number of latest commands that count."""
PERCENTILES = (50, 99)


class Punctuality:
    """What is known of the latest commands of a controller in real time."""

    def __init__(self, period: float) -> None:
        """
        Begin without any command.

        :param period: time between two ticks, s.
        """
        self.missed = 0
        self._period = period
        self._delays: deque[float] = deque(maxlen=WINDOW)
        self._ages: deque[float] = deque(maxlen=WINDOW)
        self._began = 0.0
        self._expected: float | None = None
        self._due: float | None = None

    def tick(self, now: float, lateness: float, clock: float) -> None:
        """
        Begin a period; count those that passed without a tick.

        :param now: on a clock that always runs, s.
        :param lateness: how long ago the tick should have come, s.
        :param clock: time on the clock of the ticks, which may be simulated, s.
        """
        due = clock - lateness
        if self._due is not None:
            self.missed += max(0, round((due - self._due) / self._period) - 1)
        self._began, self._due, self._expected = now, due, now - lateness

    def command(self, moment: float, ages: Mapping[str, float]) -> None:
        """
        Note the command of this period, if there was one.

        :param moment: when the latest command was published, on the clock that always runs, s.
        :param ages: of the inputs at the tick, by name, s; none where they do not matter.
        """
        if self._expected is None or moment < self._began:
            return
        self._delays.append(moment - self._expected)
        ageing = [ages[name] for name in AGEING if name in ages]
        if ageing:
            self._ages.append(max(ageing) + moment - self._began)

    def facts(self) -> dict[str, str]:
        """Return what diagnostics tell."""
        return {
            'missed periods': str(self.missed),
            **percentiles('tick to command', self._delays),
            **percentiles('age of inputs at command', self._ages),
        }


def percentiles(name: str, values: deque[float]) -> dict[str, str]:
    """
    Return percentiles as facts; none where nothing was measured.

    :param values: measured, s.
    """
    if not values:
        return {}
    found = np.percentile(list(values), PERCENTILES).tolist()
    return {
        f'{name}, p{percent} [s]': f'{value:.4f}'
        for percent, value in zip(PERCENTILES, found, strict=True)
    }
