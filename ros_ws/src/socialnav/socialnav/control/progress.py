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
"""
Time of choosing to stand after which the way was closed, so that it is free afterwards; and time
without a goal after which the next one is meant as another, wherever it is, s.
"""


class ProgressCheck:
    """
    Counts the time of driving since the robot last came nearer to its goal.

    Nearer is by way: along the plan where one is followed, else straight to the goal. What changes
    the way while the robot stands, another plan or a goal that moves, neither gives nor takes.
    Only decisions count as time, so that a robot that stands for a reason of its own, or a clock
    that jumps, makes no difference.
    """

    def __init__(self) -> None:
        self._aimed = -np.inf
        self._target: np.ndarray | None = None
        self.begin()

    def begin(self) -> None:
        """Begin anew, with all the time that there is."""
        self.complaint: str | None = None
        self.stopped = False
        self.idle = self._stood = self._driven = self._way = 0.0
        self._place = self._origin = self._goal = np.zeros(2)
        self._best: float | None = None
        self._plan: Any = None

    def aim(self, goal: np.ndarray, moment: float, settings: PolicyParameters) -> None:
        """
        Hear of a goal: begin anew, unless it is said again and again or follows something.

        :param goal: m, (2,).
        :param moment: on a clock that always runs, s.
        """
        elsewhere = self._target is None or distance(goal, self._target) >= (
            settings.progress_distance
        )
        if moment - self._aimed >= WAITED or (self.stopped and elsewhere):
            self.begin()
        self._aimed = moment
        if not self.stopped:
            self._target = goal

    def look(
        self, place: np.ndarray, goal: np.ndarray, plan: Any, left: float | None,
        settings: PolicyParameters,
    ) -> None:  # fmt: skip
        """
        See where the robot is; note it where it has come nearer.

        :param place: of the robot, m, (2,).
        :param goal: m, (2,).
        :param plan: that is followed, or None.
        :param left: of the plan, m, or None.
        """
        way = distance(goal, place) if left is None else left
        if self._best is None:
            self._origin, self._best = place, way
        elif plan is not self._plan or (plan is None and (goal != self._goal).any()):
            straight = plan is None and self._plan is None
            self._best += way - (distance(self._goal, place) if straight else self._way)
        near = settings.progress_distance
        self._place, self._goal, self._plan, self._way = place, goal, plan, way
        if self._moved() >= near and self._best - way >= near and not self.stopped:
            self.begin()
            self._place = self._origin = place
            self._goal, self._plan, self._way, self._best = goal, plan, way, way

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
            stood = self._stood >= self.idle / 2 or self._driven < near / 2
            cause = STANDS if stood else HELD
        limit = settings.progress_stop_timeout if self.stopped else settings.progress_timeout
        lack = f'not {near:g} m nearer to the goal in {limit:g} s of driving'
        end = f'; {GIVEN_UP}' if self.stopped else ''
        return f'{NO_PROGRESS}: {lack}; {cause}{end}'

    def _moved(self) -> float:
        """Return how far the robot is from where it last made progress, m."""
        return distance(self._place, self._origin)


def over(time: float, limit: float) -> bool:
    """Return whether a time is as long as a limit, s; a limit of 0 is none."""
    return 0 < limit <= time + 1e-9


def distance(one: np.ndarray, other: np.ndarray) -> float:
    """Return how far apart two places are, m."""
    return float(np.hypot(*(one - other)))
