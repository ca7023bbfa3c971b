"""Stops the robot when nothing decides any more, whatever the other clocks do."""

from collections.abc import Callable
import threading
import time


class Watchdog:
    """A thread on the steady clock that calls for help while it is not fed."""

    def __init__(self, timeout: float, on_stall: Callable[[], None]) -> None:
        """
        Start watching.

        :param timeout: time without food after which on_stall is called, again and again, s.
        :param on_stall: called in the thread of the watchdog.
        """
        self._timeout = timeout
        self._on_stall = on_stall
        self._over = threading.Event()
        self.feed()
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def feed(self) -> None:
        """Tell that a decision was made; this does not wake the thread."""
        self._due = time.monotonic() + self._timeout

    def stop(self) -> None:
        """End the thread; on_stall is not called any more."""
        self._over.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._over.wait(max(0.0, self._due - time.monotonic())):
            if time.monotonic() >= self._due:
                self.feed()
                self._on_stall()
