"""Whether detections come often enough for what a tracker has been told."""

from collections import deque
import statistics

INTERVALS = 5
"""Number of latest intervals that are looked at."""


class Rate:
    """The latest intervals between detections."""

    def __init__(self) -> None:
        """Start without an interval."""
        self._latest: float | None = None
        self._intervals: deque[float] = deque(maxlen=INTERVALS)

    def take(self, moment: float) -> None:
        """Take note of the time of detections, s; those of one moment count once."""
        interval = 0.0 if self._latest is None else moment - self._latest
        self._latest = moment
        if interval > 0:
            self._intervals.append(interval)

    def complaint(self, coast_time: float) -> str | None:
        """
        Return why nobody's velocity can be known, or None.

        :param coast_time: time without a detection after which a track dies, s.
        """
        if len(self._intervals) < INTERVALS:
            return None
        usual = statistics.median(self._intervals)
        if usual <= coast_time:
            return None
        return (
            f'detections come every {usual:.2f} s, but tracks die after coast_time '
            f'{coast_time:g} s: everybody counts as standing; set coast_time to {2 * usual:.1f}'
        )
