"""How following a path for somebody ends: the codes and their conditions are those of nav2."""

import dataclasses
import enum
import math

import numpy as np

from socialnav.control.decisions import Decision
from socialnav.control.plan import MOST_POSES
from socialnav.control.progress import distance, over
from socialnav.control.reasons import Cause, NO_PROGRESS
from socialnav.messages.conversions import ConversionError, finite, heading_of, quoted
from socialnav.messages.follow_requests import FollowRequest
from socialnav.parameters.policy import PolicyParameters
from socialnav_core.simulation.kinematics.angles import wrap
from socialnav_core.states import CrowdState

LONGEST_PAUSE = 1.0
"""Longest time between two decisions that counts, s: a clock may have been set in between."""
TURN = 0.5
"""Turning by so much is motion too, rad."""


class Code(enum.IntEnum):
    """Error codes of nav2_msgs/action/FollowPath."""

    NONE = 0
    UNKNOWN = 100
    INVALID_CONTROLLER = 101
    TF_ERROR = 102
    INVALID_PATH = 103
    PATIENCE_EXCEEDED = 104
    FAILED_TO_MAKE_PROGRESS = 105
    NO_VALID_CONTROL = 106
    CONTROLLER_TIMED_OUT = 107


@dataclasses.dataclass(frozen=True)
class Outcome:
    """How it ended."""

    code: Code = Code.NONE
    text: str = ''
    """Why; empty where the goal was reached."""


REACHED = Outcome()
REPLACED = Outcome(Code.NONE, 'a newer path has come')
FORGOTTEN = Outcome(Code.UNKNOWN, 'the goal was cancelled by ~/cancel_goal')


def refusal(request: FollowRequest, settings: PolicyParameters) -> Outcome | None:
    """Return why a request cannot be begun, or None."""
    if request.controller_id not in ('', settings.controller_id):
        return unknown_name(Code.INVALID_CONTROLLER, request.controller_id, settings.controller_id)
    for wanted, known in (
        (request.goal_checker_id, settings.goal_checker_id),
        (request.progress_checker_id, settings.progress_checker_id),
    ):
        if wanted not in ('', known):
            return unknown_name(Code.UNKNOWN, wanted, known)
    try:
        check_path(request, settings)
    except ConversionError as error:
        return Outcome(Code.INVALID_PATH, str(error))
    return None


def unknown_name(code: Code, wanted: str, known: str) -> Outcome:
    """Return the outcome of a name that nobody has here."""
    return Outcome(code, f'there is no {quoted(wanted)} here, only {known!r}')


def check_path(request: FollowRequest, settings: PolicyParameters) -> None:
    """
    Refuse a path that cannot be followed.

    :raises ConversionError: it is empty or too long, or has frames or numbers that cannot be.
    """
    path = request.path
    if not len(path.points):
        raise ConversionError('path: empty')
    if len(path.points) > MOST_POSES:
        raise ConversionError(f'path: {len(path.points)} poses, more than {MOST_POSES}')
    if path.frame not in ('', path.header.frame_id):
        raise ConversionError(f'path: a pose in another frame, {quoted(path.frame)}')
    finite('path', 'position', path.points)
    if settings.goal_yaw_tolerance < math.pi:
        heading_of('path: last pose', request.end.pose.orientation)


def same_end(one: FollowRequest, other: FollowRequest) -> bool:
    """Return whether two paths end in one pose, so that the goal is the same."""
    first, second = one.end, other.end
    return first.header.frame_id == second.header.frame_id and first.pose == second.pose


class Movement:
    """
    Whether a robot moves at all, in whatever direction.

    It must leave a circle of progress_distance, or turn, within progress_timeout, ever anew.
    """

    def __init__(self) -> None:
        self._origin: tuple[np.ndarray, float] | None = None
        self._idle = 0.0

    def look(self, state: CrowdState | None, elapsed: float, settings: PolicyParameters) -> bool:
        """
        Return whether the robot has moved lately.

        :param state: where it is now, batch of one; None where nobody knows.
        :param elapsed: time since the last look, s.
        """
        self._idle += elapsed
        if state is not None:
            place, heading = state.robot.position[0], float(state.robot.heading[0])
            if self._origin is None or self._has_left(place, heading, settings):
                self._origin, self._idle = (place, heading), 0.0
        return not over(self._idle, settings.progress_timeout)

    def _has_left(self, place: np.ndarray, heading: float, settings: PolicyParameters) -> bool:
        """Return whether the robot is far from where it was, or looks elsewhere."""
        assert self._origin is not None
        origin, direction = self._origin
        turned = abs(float(wrap(np.array(heading - direction))))
        return distance(place, origin) >= settings.progress_distance or turned >= TURN


class Patience:
    """For how long there has been no command; after failure_tolerance that is a failure."""

    def __init__(self) -> None:
        self._waited = 0.0

    def look(
        self, decision: Decision, elapsed: float, settings: PolicyParameters
    ) -> Outcome | None:
        """
        Return how it ends, or None.

        :param elapsed: time since the last decision, s.
        """
        if decision.cause is None:
            self._waited = 0.0
            return None
        self._waited += elapsed
        limit = settings.failure_tolerance
        if limit < 0 or limit > 0 and self._waited < limit:
            return None
        code = {
            Cause.INPUT: Code.CONTROLLER_TIMED_OUT,
            Cause.FRAME: Code.TF_ERROR,
        }.get(decision.cause, Code.PATIENCE_EXCEEDED if limit else Code.NO_VALID_CONTROL)
        return Outcome(code, decision.reason or '')


class Following:
    """A path that is being followed: each decision may end it."""

    def __init__(self, now: int) -> None:
        """
        Begin.

        :param now: ns.
        """
        self._latest = now
        self._movement = Movement()
        self._patience = Patience()

    def look(
        self, decision: Decision, state: CrowdState | None, now: int, settings: PolicyParameters
    ) -> Outcome | None:
        """
        Return how it ends with a decision, or None.

        :param state: in which it was made, batch of one; None where nobody knows it.
        :param now: ns.
        """
        elapsed = min(max((now - self._latest) * 1e-9, 0.0), LONGEST_PAUSE)
        self._latest = now
        if decision.cause is Cause.ARRIVED:
            return REACHED
        if decision.cause is Cause.NO_GOAL:
            return FORGOTTEN
        if decision.cause is Cause.PROGRESS:
            return Outcome(Code.FAILED_TO_MAKE_PROGRESS, decision.reason or '')
        if not self._movement.look(state, elapsed, settings):
            lack = f'moved less than {settings.progress_distance:g} m'
            text = f'{NO_PROGRESS}: {lack} in {settings.progress_timeout:g} s'
            return Outcome(Code.FAILED_TO_MAKE_PROGRESS, text)
        return self._patience.look(decision, elapsed, settings)
