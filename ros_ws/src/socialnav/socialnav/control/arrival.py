"""Whether a robot has arrived: its place first, then, where that is wanted, its heading."""

import math

from geometry_msgs.msg import PoseStamped
import numpy as np

from socialnav.control.progress import over
from socialnav.control.reasons import NO_PROGRESS
from socialnav.messages.conversions import heading_of, placement_of
from socialnav.messages.frames import Locate
from socialnav.parameters.policy import PolicyParameters
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.simulation.kinematics.angles import wrap
from socialnav_core.simulation.kinematics.limits import changed, Limits
from socialnav_core.states import CrowdState

GAIN = 2.0
"""Turn rate for each rad that is missing, 1/s: the last half radian is turned ever more slowly."""
NEARER = 0.05
"""Turning nearer to the heading by so much is progress, rad."""
STIFF = f'{NO_PROGRESS}: the robot is commanded to turn and does not'


class Arrival:
    """
    What a robot has reached of its goal.

    A place that was reached once stays reached, so that a robot that turns there, and is moved by
    that a little, does not drive to it again.
    """

    def __init__(self) -> None:
        self.begin()

    def begin(self) -> None:
        """Have another goal."""
        self.at_place = self.reached = False
        self.complaint: str | None = None
        self._best, self._idle = math.inf, 0.0

    def look(self, state: CrowdState, heading: float | None, settings: PolicyParameters) -> None:
        """
        See where the robot is.

        :param state: with the goal, batch of one.
        :param heading: to be reached, rad; None where any will do.
        """
        offset = state.robot.goal[0] - state.robot.position[0]
        self.at_place = self.at_place or bool(np.hypot(*offset) < settings.goal_tolerance)
        if not self.at_place or self.reached:
            return
        missing = 0.0 if heading is None else abs(heading_error(state, heading))
        self.reached = missing <= settings.goal_yaw_tolerance
        self._watch(missing, settings)

    def _watch(self, missing: float, settings: PolicyParameters) -> None:
        """
        See whether the robot turns; each look counts as a period of turning.

        :param missing: angle to the heading, rad.
        """
        self._idle += settings.period
        if missing <= self._best - NEARER:
            self._best, self._idle = missing, 0.0
        stiff = over(self._idle, settings.progress_timeout) and not self.reached
        self.complaint = STIFF if stiff else None


def wanted_heading(goal: PoseStamped, settings: PolicyParameters, locate: Locate) -> float | None:
    """
    Return the heading that a goal wants in the planning frame, rad; None where any will do.

    :raises ConversionError: an orientation that is none, or a frame that nobody knows.
    """
    if settings.goal_yaw_tolerance >= math.pi or settings.lockstep:
        return None
    placement = placement_of(
        'goal_pose', goal.header, settings.planning_frame, locate, newest=True
    )
    return heading_of('goal_pose', goal.pose.orientation) + placement.heading


def heading_error(state: CrowdState, heading: float) -> float:
    """Return how far a robot must turn to the left to look along a heading, rad in [-pi, pi)."""
    return float(wrap(heading - state.robot.heading)[0])


def turn_rate(missing: float, present: float, limits: Limits) -> float:
    """
    Return how fast to turn on the spot, rad/s.

    :param missing: angle to turn, rad.
    :param present: turn rate now, rad/s.
    """
    braking = math.sqrt(2 * limits.angular_acceleration * abs(missing))
    wanted = math.copysign(min(GAIN * abs(missing), braking, limits.turn_rate), missing)
    change = limits.angular_acceleration * limits.period
    return float(changed(np.array(present), np.array(wanted), limits.turn_rate, change))


def turning(
    state: CrowdState, heading: float, settings: PolicyParameters
) -> tuple[np.ndarray, float]:
    """
    Return the command that turns a robot on the spot, (2,), and its turn rate besides, rad/s.

    :param state: when the command takes effect, batch of one.
    :param heading: to be reached, rad.
    """
    present = float(state.robot.turn_rate[0])
    rate = turn_rate(heading_error(state, heading), present, settings.limits)
    if kinematics_of(settings.kinematics).has_heading:
        return np.array([0.0, rate]), 0.0
    return np.zeros(2), rate
