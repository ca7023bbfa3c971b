"""What the log is told: what is true, soon, and not too often."""

from collections.abc import Callable
import time

PAUSE = 1.0
"""Shortest time between two lines, s."""


class Announcer:
    """
    Says a text where it is another one than it said last.

    It is asked again and again, so that what comes too soon after a line is said later, if it is
    still true then: the last line of a log is never one that is not true any more.
    """

    def __init__(
        self, say: Callable[[str], object], steady: Callable[[], float] = time.monotonic
    ) -> None:
        """
        Have said nothing.

        :param say: writes a line.
        :param steady: a clock that always runs, s.
        """
        self._say = say
        self._steady = steady
        self._said: str | None = None
        self._moment = -PAUSE

    def tell(self, text: str, *, aloud: bool = True) -> None:
        """
        Say what is true.

        :param aloud: whether it is worth a line where nothing has been said yet.
        """
        if text == self._said or not (aloud or self._said):
            return
        now = self._steady()
        if now - self._moment >= PAUSE:
            self._said, self._moment = text, now
            self._say(text)
