"""Whether a robot that drives comes nearer to its goal."""

from typing import Any

import numpy as np

from socialnav.control.reasons import GIVEN_UP, NO_PROGRESS
from socialnav.parameters.policy import PolicyParameters

STANDS = 'the policy chooses to stand'
HELD = 'the robot is commanded and does not move'
ASTRAY = 'the robot moves, but not towards the goal'
STANDSTILL = 0.01
"""A policy that chooses less chooses to stand, m/s."""
WAITED = 5.0
"""Time of choosing to stand after which the way was closed, so that it is free afterwards, s."""


class ProgressCheck:
    """
    Counts the time of driving since the robot last came nearer to its goal.

    Nearer is by way: along the plan where one is followed, else straight to the goal. A way that
    is measured anew, along another plan, is no progress. Only decisions count as time, so that a
    robot that stands for a reason of its own, or a clock that jumps, makes no difference.
    """

    def __init__(self) -> None:
        self.begin()

    def begin(self) -> None:
        """Begin a run, with all the time that it may have."""
        self.complaint: str | None = None
        self.stopped = False
        self.idle = self._stood = self._driven = 0.0
        self._place = self._origin = np.zeros(2)
        self._best: float | None = None
        self._measure: Any = None

    def look(
        self, place: np.ndarray, way: float, measure: Any, settings: PolicyParameters
    ) -> None:
        """
        See where the robot is; note it where it has come nearer.

        :param place: of the robot, m, (2,).
        :param way: left to the goal, m.
        :param measure: what the way is measured along: a plan, or None.
        """
        if self._best is None:
            self._origin, self._best, self._measure = place, way, measure
        if measure is not self._measure:
            both_are_plans = measure is not None and self._measure is not None
            self._best = max(self._best, way) if both_are_plans else way
        near = settings.progress_distance
        self._place, self._measure = place, measure
        if self._moved() >= near and self._best - way >= near and not self.stopped:
            self.begin()
            self._place = self._origin = place
            self._best, self._measure = way, measure

    def choose(self, speed: float, settings: PolicyParameters) -> None:
        """
        Count a decision of the policy, also one that is not obeyed since the robot has stopped.

        :param speed: that it chose, m/s; zero counts as any other.
        """
        standing = speed < STANDSTILL
        free = self._stood >= WAITED and not standing
        if self.stopped and (free or not over(self.idle, settings.progress_stop_timeout)):
            self.begin()
        self._stood = self._stood + settings.period if standing else 0.0
        if self.stopped:
            return
        self.idle += settings.period
        self._driven += speed * settings.period
        self.stopped = over(self.idle, settings.progress_stop_timeout)
        if self.stopped or (self.complaint is None and over(self.idle, settings.progress_timeout)):
            self.complaint = self._complaint(settings)

    def _complaint(self, settings: PolicyParameters) -> str:
        """Return what is wrong, and why, as far as can be seen from here."""
        near = settings.progress_distance
        if self._moved() >= near:
            cause = ASTRAY
        else:
            cause = STANDS if self._driven < near / 2 else HELD
        limit = settings.progress_stop_timeout if self.stopped else settings.progress_timeout
        lack = f'not {near:g} m nearer to the goal in {limit:g} s of driving'
        end = f'; {GIVEN_UP}' if self.stopped else ''
        return f'{NO_PROGRESS}: {lack}; {cause}{end}'

    def _moved(self) -> float:
        """Return how far the robot is from where it last made progress, m."""
        return float(np.hypot(*(self._place - self._origin)))


def over(time: float, limit: float) -> bool:
    """Return whether a time is as long as a limit, s; a limit of 0 is none."""
    return 0 < limit <= time + 1e-9
