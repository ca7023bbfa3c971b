"""What cannot be true of inputs that look well one by one."""

from collections.abc import Sequence
import math

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry

from socialnav.control.leaps import Leaps
from socialnav.control.odometry_check import JUMP, Jumps, MotionCheck, Moved, moved
from socialnav.control.reasons import GIVEN_UP
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters.policy import PolicyParameters
from socialnav_msgs.msg import AgentStates

FORGIVEN = 1.0
"""Time after a goal elsewhere in which a jump is a new beginning, as in a simulator, s."""


class Doubts:
    """Compares odometry with itself, and people with where they were."""

    def __init__(self) -> None:
        """Doubt nothing yet."""
        self._jumps, self._motion, self._leaps = Jumps(), MotionCheck(), Leaps()
        self._latest: Odometry | None = None
        self._goal: PoseStamped | None = None
        self._jump: str | None = None
        self._aimed = -FORGIVEN

    def reason(
        self, odometry: Odometry, goal: PoseStamped, settings: PolicyParameters
    ) -> str | None:
        """
        Look at the newest odometry; return why the robot must stand, or None.

        After a jump it is not where its goal was told for, so that another goal, or the same one
        with another stamp, is waited for.
        """
        moment = nanoseconds_of(odometry.header.stamp) * 1e-9
        if goal is not self._goal:
            self._aim(goal, moment)
        step = moved(self._latest, odometry, settings.base_frame)
        if odometry is not self._latest:
            self._latest = odometry
            self._take(step, moment, settings)
        return self._jump

    def _aim(self, goal: PoseStamped, moment: float) -> None:
        """
        Take a goal that may be another one.

        :param moment: of the newest odometry, s.
        """
        before, self._goal = self._goal, goal
        if before is None or apart(before, goal) > JUMP:
            self._aimed = moment
        typed = not nanoseconds_of(goal.header.stamp)
        if before is None or typed or goal != before:
            self._jump = None

    def _take(self, step: Moved | None, moment: float, settings: PolicyParameters) -> None:
        """
        Judge a step of odometry; None where there is none to compare with.

        :param moment: of the newest odometry, s.
        """
        jump = None if step is None else self._jumps.found(step, settings.max_speed)
        self._motion.take(None if jump else step)
        if jump is not None and not 0 <= moment - self._aimed <= FORGIVEN:
            self._jump = f'{jump}; {GIVEN_UP}'

    def look_at_people(self, lists: Sequence[AgentStates], moment: float) -> None:
        """
        See whether people are where they can be.

        :param moment: on a clock that always runs, s.
        """
        self._leaps.take(lists, moment)

    def concerns(self, moment: float) -> list[str]:
        """
        Return what is wrong though the robot drives.

        :param moment: on a clock that always runs, s.
        """
        return [one for one in (self._motion.complaint, self._leaps.complaint(moment)) if one]


def apart(one: PoseStamped, other: PoseStamped) -> float:
    """Return how far apart two goals are, m; infinity where their frames differ."""
    if one.header.frame_id != other.header.frame_id:
        return math.inf
    here, there = one.pose.position, other.pose.position
    return math.hypot(here.x - there.x, here.y - there.y)
