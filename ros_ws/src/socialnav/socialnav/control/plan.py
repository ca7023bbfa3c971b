"""A planner's path, followed by heading for a point on it that is always a little farther on."""

import numpy as np

from socialnav.messages.conversions import ConversionError, finite, placement_of, quoted
from socialnav.messages.frames import Locate, not_asked
from socialnav.messages.paths import ReadPath

NO_PLAN = 'none'
FOLLOWED = 'followed'
MOST_POSES = 100_000
"""Poses of the longest plan that is followed, so that a decision stays in time."""


class PlanFollower:
    """Remembers how far along the newest plan the robot has come."""

    def __init__(self) -> None:
        self.note = NO_PLAN
        self.followed: ReadPath | None = None
        self.way: float | None = None
        self._message: ReadPath | None = None
        self._progress: float | None = None

    def heading_point(
        self,
        plan: ReadPath | None,
        position: np.ndarray,
        goal: np.ndarray,
        ahead: float,
        frame: str,
        locate: Locate = not_asked,
        complaint: str | None = None,
    ) -> np.ndarray:
        """
        Return where to head for, m, (2,): the goal itself where the plan cannot be used.

        `note` says then whether the plan is followed, or why it is ignored; `followed` is the plan
        that is, and `way` what is left of it, m, None without one.

        :param position: of the robot, m, (2,).
        :param goal: where the run ends, m, (2,).
        :param ahead: way along the plan from the robot to the point, m.
        :param frame: of position and goal.
        :param complaint: what is wrong with the plan already.
        """
        if plan is not self._message:
            self._message, self._progress = plan, None
        self.followed = self.way = None
        if plan is None and complaint is None:
            self.note = NO_PLAN
            return goal
        try:
            if plan is None or complaint is not None:
                raise ConversionError(complaint or 'plan: none')
            points = plan_points(plan, goal, ahead, frame, locate)
        except ConversionError as error:
            self.note = f'ignored: {error}'
            return goal
        self.note, self.followed = FOLLOWED, plan
        self._progress = progress_along(points, position, self._progress, ahead)
        self.way = length_of(points) - self._progress
        return point_at(points, self._progress + ahead, goal)


def plan_points(
    plan: ReadPath, goal: np.ndarray, ahead: float, frame: str, locate: Locate
) -> np.ndarray:
    """
    Return the corners of a plan in a frame, m, (corners, 2).

    :param goal: where the plan must end, m, (2,).
    :param ahead: largest distance between its end and the goal, m.
    :raises ConversionError: a plan that cannot be used.
    """
    count = len(plan.points)
    if count > MOST_POSES:
        raise ConversionError(f'plan: {count} poses, more than {MOST_POSES}')
    if plan.frame not in ('', plan.header.frame_id):
        raise ConversionError(f'plan: a pose in another frame, {quoted(plan.frame)}')
    if not count:
        raise ConversionError('plan: empty')
    placement = placement_of('plan', plan.header, frame, locate, newest=True)
    points = placement.placed(finite('plan', 'position', plan.points))
    missing = float(np.hypot(*(points[-1] - goal)))
    if missing > ahead:
        raise ConversionError(f'plan: it ends {missing:.2f} m from the goal')
    return points


def progress_along(
    points: np.ndarray, position: np.ndarray, before: float | None, window: float
) -> float:
    """
    Return how far along a path its point nearest to the robot is, m.

    :param points: corners of the path, m, (corners, 2).
    :param position: of the robot, m, (2,).
    :param before: the result that must not be undercut; None on a new path, where any point may
        be the nearest.
    :param window: the result is farther from the former one by so much at most, m, so that a
        path that comes back to itself is not cut short.
    """
    segments = np.diff(points, axis=0)
    lengths = np.hypot(segments[:, 0], segments[:, 1])
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    low, high = (0.0, starts[-1]) if before is None else (before, before + window)
    first, last = (np.clip(bound - starts[:-1], 0.0, lengths) for bound in (low, high))
    unit = segments / np.where(lengths > 0, lengths, 1.0)[:, None]
    along = np.clip(((position - points[:-1]) * unit).sum(axis=1), first, last)
    offset = points[:-1] + along[:, None] * unit - position
    distance = np.hypot(offset[:, 0], offset[:, 1])
    distance[(starts[1:] < low) | (starts[:-1] > high)] = np.inf
    if not len(segments):
        return 0.0
    nearest = int(distance.argmin())
    return max(float(starts[nearest] + along[nearest]), low)


def length_of(points: np.ndarray) -> float:
    """
    Return how long a path is, m.

    :param points: corners of the path, m, (corners, 2).
    """
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def point_at(points: np.ndarray, way: float, end: np.ndarray) -> np.ndarray:
    """
    Return the point of a path at a length from its start, m, (2,).

    :param points: corners of the path, m, (corners, 2).
    :param way: the length, m.
    :param end: returned beyond the end of the path, m, (2,).
    """
    segments = np.diff(points, axis=0)
    starts = np.concatenate([[0.0], np.cumsum(np.hypot(segments[:, 0], segments[:, 1]))])
    if way >= starts[-1]:
        return end
    return np.array([np.interp(way, starts, points[:, axis]) for axis in (0, 1)])
