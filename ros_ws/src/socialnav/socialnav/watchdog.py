"""Stops the robot when nothing decides any more, whatever the other clocks do."""

from collections.abc import Callable
import threading


class Watchdog:
    """A thread on the steady clock that calls for help while it is not fed."""

    def __init__(self, timeout: float, on_stall: Callable[[], None]) -> None:
        """
        Start watching.

        :param timeout: time without food after which on_stall is called, again and again, s.
        :param on_stall: called in the thread of the watchdog.
        """
        self.timeout = timeout
        self._on_stall = on_stall
        self._food = threading.Event()
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def feed(self) -> None:
        """Tell that a decision was made."""
        self._food.set()

    def stop(self) -> None:
        """End the thread; on_stall is not called any more."""
        self._over.set()
        self._food.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._over.is_set():
            fed = self._food.wait(self.timeout)
            self._food.clear()
            if not fed and not self._over.is_set():
                self._on_stall()
