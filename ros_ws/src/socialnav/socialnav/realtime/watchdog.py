"""Stops the robot when nothing decides any more, whatever the other clocks do."""

from collections.abc import Callable
import threading
import time


class Watchdog:
    """A thread on the steady clock that calls for help while it is not fed."""

    def __init__(
        self, timeout: float, on_stall: Callable[[], None], fed: float | None = None
    ) -> None:
        """
        Start watching.

        :param timeout: time without food after which on_stall is called, again and again, s.
        :param on_stall: called in the thread of the watchdog, which ends where that raises.
        :param fed: when there was food last, on the monotonic clock, s; None for now.
        """
        self.fed = time.monotonic() if fed is None else fed
        self._timeout = timeout
        self._on_stall = on_stall
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def feed(self) -> None:
        """Tell that a decision was made; this does not wake the thread."""
        self.fed = time.monotonic()

    def stop(self) -> None:
        """End the thread; on_stall is not called any more."""
        self._over.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._over.wait(max(0.0, self._time_left())):
            if self._time_left() <= 0:
                self.feed()
                self._on_stall()

    def _time_left(self) -> float:
        return self.fed + self._timeout - time.monotonic()
