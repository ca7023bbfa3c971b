"""Ctrl-C and SIGTERM as a request, so that a run can save itself before it stops."""

import signal
import threading
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM)


class TrainingInterrupted(Exception):
    """A run that was asked to stop and saved itself; its text says how to go on."""

    def __init__(self, message: str, number: int = signal.SIGINT) -> None:
        """
        Keep what is said.

        :param number: of the signal.
        """
        super().__init__(message)
        self.number = number


class Interruption:
    """
    Notes the first signal while its block runs; a second one acts as it always does.

    Only the main thread may handle signals; in another, nothing is caught.
    """

    def __init__(self) -> None:
        """Wait to be entered."""
        self.number = 0
        """Of the signal, 0 for none so far."""
        self._previous: dict[int, object] = {}

    @property
    def requested(self) -> bool:
        """Return whether a signal came."""
        return self.number != 0

    def __enter__(self) -> 'Interruption':
        """Take over the signals."""
        if threading.current_thread() is threading.main_thread():
            self._previous = {number: signal.signal(number, self._note) for number in SIGNALS}
        return self

    def __exit__(self, *error: object) -> None:
        """Give the signals back."""
        self._restore()

    def _note(self, number: int, frame: FrameType | None) -> None:
        """Remember the request."""
        self.number = number
        self._restore()

    def _restore(self) -> None:
        """Hand the signals back to who had them before."""
        for number, handler in self._previous.items():
            signal.signal(number, handler)  # type: ignore[arg-type]
        self._previous = {}
