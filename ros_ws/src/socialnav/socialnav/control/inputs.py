"""The newest message of each input, and what keeps a robot from acting on them."""

from collections.abc import Callable, Sequence
import math
import time
from typing import Any

from geometry_msgs.msg import PoseStamped

from socialnav.control.lists import Lists
from socialnav.messages.sources import source_of
from socialnav.messages.stamps import nanoseconds_of
from socialnav.messages.unread import content, Unread
from socialnav.parameters.policy import PolicyParameters
from socialnav_msgs.msg import AgentStates

NAMES = ('odom', 'pedestrians', 'obstacles', 'goal_pose')
OPTIONAL = ('plan', 'map')
"""Inputs that a state in lockstep does not have."""
AGEING = ('odom', 'pedestrians')
ANOTHER_CLOCK = 1e8
"""Three years, s: a stamp so old is none, or that of a simulated clock."""
OUT_OF_STEP = 'are the clocks in step?'
ANOTHER_TIME = 'it has no stamp, or use_sim_time differs between the nodes'
"""What may be wrong with a stamp."""
UNREADABLE = 'a message that cannot be read'
LISTS = ('pedestrians', 'obstacles')
"""Inputs of which several publishers may tell a part each."""


class Inputs:
    """
    Messages as they come.

    odom and pedestrians age; obstacles only where a time-out is set; a goal never does.
    """

    def __init__(self, steady: Callable[[], float] = time.monotonic) -> None:
        """
        Have nothing yet.

        :param steady: a clock that always runs, s.
        """
        self._steady = steady
        self._came: dict[str, float] = {}
        self._outdated: dict[str, float] = {}
        self._newest: dict[str, Any] = {}
        self._lists = {name: Lists(name) for name in LISTS}
        self._unread: set[str] = set()
        self._cancelled: PoseStamped | None = None

    def store(self, name: str, message: Any, merged: bool = True) -> None:
        """
        Keep a message in place of the earlier one from there.

        A goal that was cancelled does not come back. A goal without a stamp was typed by
        somebody, who means it each time.

        :param name: one of NAMES or OPTIONAL.
        :param message: it has a header, once it has been read.
        :param merged: whether lists of several publishers count together; else the newest does.
        """
        if (
            name == 'goal_pose'
            and message == self._cancelled
            and nanoseconds_of(message.header.stamp)
        ):
            return
        if name in LISTS:
            self._lists[name].store(source_of(message) if merged else '', message)
        self._newest[name], self._came[name] = message, self._steady()
        if name in NAMES:
            self._unread.add(name)

    def cancel_goal(self) -> bool:
        """Forget the goal; return whether there was one."""
        goal = self._newest.pop('goal_pose', None)
        self._cancelled = goal or self._cancelled
        return goal is not None

    def forget(self, name: str) -> None:
        """Have an input no more."""
        self._newest.pop(name, None)

    def hear_of(self, name: str, publishers: Sequence[str]) -> None:
        """
        Take note of who publishes a list.

        :param name: one of LISTS.
        :param publishers: full names of their nodes.
        """
        self._lists[name].hear_of(publishers)

    def lists(self, name: str) -> list[AgentStates]:
        """
        Return the newest list of each publisher, none of which is unreadable.

        :param name: one of LISTS.
        """
        return [message for message in self._lists[name].all() if message is not None]

    def ages(self, now: int) -> dict[str, float]:
        """
        Return how old the inputs are that there are, s; of several lists the oldest counts.

        :param now: ns, on the clock of the stamps.
        """
        known = [name for name in (*NAMES, *OPTIONAL) if self.newest(name) is not None]
        return {name: (now - min(self._stamps(name))) * 1e-9 for name in known}

    def newest(self, name: str) -> Any:
        """
        Return the newest message of an input, or None, also where it cannot be read.

        :param name: one of NAMES or OPTIONAL.
        """
        if name in LISTS:
            return self._lists[name].newest()
        message = self._newest.get(name)
        if isinstance(message, Unread):  # others are not put back: they may be gone by now
            message = self._newest[name] = content(message)
        return message

    def stamp(self, name: str) -> int:
        """
        Return the time of the newest message of an input, ns, 0 where there is none.

        :param name: one of NAMES.
        """
        return max(self._stamps(name), default=0)

    def _stamps(self, name: str) -> list[int]:
        """Return the times of the messages of an input that count, ns."""
        messages = self.lists(name) if name in LISTS else [self.newest(name)]
        return [nanoseconds_of(one.header.stamp) for one in messages if one is not None]

    def take_complete_state(self) -> bool:
        """Return whether all inputs came with one stamp since the last such state; take them."""
        complete = len(self._unread) == len(NAMES)
        if complete and len({self.stamp(name) for name in NAMES}) == 1:
            self._unread.clear()
            return True
        return False

    def complaint(self, now: int, settings: PolicyParameters) -> str | None:
        """
        Return why the inputs cannot be acted on, or None.

        :param now: ns, on the clock of the stamps.
        """
        wanted = [*AGEING, 'goal_pose']
        wanted += ['obstacles'] * settings.require_obstacles + ['map'] * settings.use_map
        for name in wanted:
            if name not in self._newest:
                return f'no {name}'
        for name in (*AGEING, 'obstacles'):  # read only now, since nothing is missing
            if name in self._newest and self.newest(name) is None:
                return f'{name}: {UNREADABLE}' + ', or is too long' * (name != 'odom')
        if settings.lockstep:
            return None
        return self._complaint_of_ages(now, settings) or self._complaint_of_lists()

    def _complaint_of_ages(self, now: int, settings: PolicyParameters) -> str | None:
        """Return what is wrong with the age of an input, or None."""
        ages, timeouts = self.ages(now), self._timeouts(settings)
        for name, timeout in timeouts.items():
            if name not in LISTS:
                told = [('', ages[name])]
            else:
                told = self._lists[name].ages(now, timeout)
            here = self._here(name, ages[name], timeout) if len(told) == 1 else math.inf
            for node, age in told:
                text = age_complaint(name, age, timeout, here)
                if text is not None:
                    return f'{text}, told by {node}' if node and len(told) > 1 else text
        return None

    def _complaint_of_lists(self) -> str | None:
        """Return what is wrong with the lists of several publishers, or None."""
        for name, lists in self._lists.items():
            if None in lists.all():
                return f'{name}: {UNREADABLE}, or is too long'
        return next(filter(None, (lists.complaint() for lists in self._lists.values())), None)

    def _here(self, name: str, age: float, timeout: float) -> float:
        """
        Return how long ago an input came that is too old and was before, s; else infinity.

        Where a clock has jumped, the message before the jump is too old and the next one is not.
        """
        if age <= timeout:
            self._outdated.pop(name, None)
            return math.inf
        came = self._came[name]
        first = self._outdated.setdefault(name, came)
        return self._steady() - came if came > first else math.inf

    def time_left(self, now: int, settings: PolicyParameters) -> float:
        """
        Return the time until the first input is too old, s; negative once one is.

        :param now: ns, on the clock of the stamps.
        """
        ages = self.ages(now)
        limits = self._timeouts(settings)
        return min(limits[name] - ages.get(name, math.inf) for name in limits)

    def _timeouts(self, settings: PolicyParameters) -> dict[str, float]:
        """Return the largest age of each input that ages, s."""
        timeouts = dict.fromkeys(AGEING, settings.input_timeout)
        if settings.obstacles_timeout > 0 and 'obstacles' in self._newest:
            timeouts['obstacles'] = settings.obstacles_timeout
        return timeouts

    def plan_complaint(self, now: int, settings: PolicyParameters) -> str | None:
        """
        Return why the plan cannot be followed, or None where it is fresh or does not age.

        :param now: ns, on the clock of the stamps.
        """
        if 'plan' in self._newest and self.newest('plan') is None:
            return f'plan: {UNREADABLE}'
        if settings.plan_timeout == 0 or 'plan' not in self._newest:
            return None
        return age_complaint('plan', self.ages(now)['plan'], settings.plan_timeout)


def age_complaint(name: str, age: float, timeout: float, here: float = math.inf) -> str | None:
    """
    Return what is wrong with the age of an input, or None.

    :param age: by its stamp, s, negative in the future.
    :param timeout: the largest age, s; a stamp as far in the future is as bad.
    :param here: time since it came, s, by a clock that always runs.
    """
    if age < -timeout:
        return f'{name} from the future: {OUT_OF_STEP if age > -ANOTHER_CLOCK else ANOTHER_TIME}'
    if age <= timeout:
        return None
    old = f'{name} older than {timeout:g} s'
    if age - here <= timeout:
        return old
    if age > ANOTHER_CLOCK:
        return f'{old} by its stamp, though it has just come: {ANOTHER_TIME}'
    return f'{old} by its stamp, though it has just come: {OUT_OF_STEP}'
