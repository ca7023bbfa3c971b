"""For which moment detections count, whatever their stamps do."""

from collections.abc import Callable
import time

from socialnav.messages.conversions import ConversionError

ACCEPTED_DELAY = 0.2
"""Age relative to the newest detections up to which others count as seen with them, s."""
CLOCK_STEP = 1.0
"""Step of the stamps, beyond the time that has gone by, that is a clock that was set, s."""
CALM = 5.0
"""Time without such a step after which stamps are trusted again, s."""


class Moments:
    """The times of detections of several detectors on one clock."""

    def __init__(self, steady: Callable[[], float] = time.monotonic) -> None:
        """
        Start without a moment.

        :param steady: a clock that always runs, s.
        """
        self._steady = steady
        self._newest, self._heard = 0, 0.0
        self._stepped = -CALM
        self._distrusted = False

    def take(self, stamp: int) -> int:
        """
        Return the time for which detections count, ns.

        Of several detectors one is slower than another: what it saw shortly before the newest
        detections counts as seen with them. A larger step is a clock that was set; steps
        again and again are clocks that differ, each of which would make the others' people
        strangers.

        :param stamp: of the detections, ns.
        :raises ConversionError: detections that count for no moment.
        """
        if stamp <= 0:
            raise ConversionError('detections without a stamp')
        now, newest = self._steady(), self._newest or stamp
        step, elapsed = (stamp - newest) * 1e-9, now - self._heard
        if -CLOCK_STEP <= step < -ACCEPTED_DELAY:
            raise ConversionError(f'detections {-step:.2f} s older than the newest')
        if -ACCEPTED_DELAY <= step < 0:
            stamp = newest
        self._newest, self._heard = stamp, now
        self._judge(not -CLOCK_STEP <= step <= elapsed + CLOCK_STEP, now)
        if self._distrusted:
            raise ConversionError(
                f'stamps of detections jump again and again (by {step:.1f} s): '
                'the clocks of the detectors are not in step'
            )
        return stamp

    def _judge(self, stepped: bool, now: float) -> None:
        """Distrust stamps from the second step on, until they have been calm for a while."""
        calm = now - self._stepped >= CALM
        if stepped:
            self._distrusted = not calm
            self._stepped = now
        elif calm:
            self._distrusted = False
