"""Rehearses each decision shortly before it is due, so that it finds the processor warm."""

from rclpy.node import Node
from rclpy.timer import Timer

from socialnav.control.controller import Controller
from socialnav.realtime.alarm import Alarm

ADVANCE = 0.001
"""Time between the end of a rehearsal and the tick, s: what it has fetched is soon lost again."""
COLD = 1.5
"""Duration of a rehearsal, which finds nothing warm, in durations of a decision."""
PAUSE = 0.02
"""Shortest time without a decision after which a rehearsal is worth its time, s."""


class Rehearsal:
    """
    Lets a controller rehearse between two ticks that are far apart.

    In a tenth of a second other programs push the code and the data of a decision out of the
    processor's caches. To fetch them takes longer than to decide.
    """

    def __init__(self, node: Node, ticks: Timer, controller: Controller) -> None:
        """
        Rehearse nothing yet.

        :param node: whose executor calls.
        :param ticks: the timer of decisions.
        :param controller: rehearses.
        """
        self._ticks = ticks
        self._controller = controller
        self._alarm = Alarm(node, controller.rehearse, ticks.clock)

    def expect(self) -> None:
        """Rehearse before the next tick, unless that is near or the rehearsal would delay it."""
        until_tick = self._ticks.time_until_next_call() * 1e-9
        delay = until_tick - ADVANCE - COLD * self._controller.tally.decision_time
        if delay > PAUSE:
            self._alarm.set(delay)

    def close(self) -> None:
        """Rehearse no more."""
        self._alarm.close()
