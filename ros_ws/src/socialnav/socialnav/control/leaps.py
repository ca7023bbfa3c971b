"""People who are said to move as nobody can."""

from collections.abc import Sequence
import math

import numpy as np

from socialnav.messages.stamps import nanoseconds_of
from socialnav_core.states import CrowdState
from socialnav_msgs.msg import AgentStates

FASTEST = 10.0
"""Nobody runs faster, m/s."""
LEAP = 1.0
"""What the place of a person may be off besides, m."""
TOLD = 3.0
"""Time for which a leap is told, s."""
Places = dict[tuple[str, int], tuple[float, float, float]]


class Leaps:
    """Remembers where people were, by their ids, and tells who cannot be where it is now."""

    def __init__(self) -> None:
        """Know nobody."""
        self._places: Places = {}
        self._words = ''
        self._seen = -TOLD

    def take(self, lists: Sequence[AgentStates], moment: float) -> None:
        """
        See who is where.

        :param moment: on a clock that always runs, s.
        """
        places = places_of(lists)
        for name, (x, y, time) in places.items():
            before = self._places.get(name)
            if before is None or time <= before[2]:
                continue
            way, elapsed = math.hypot(x - before[0], y - before[1]), time - before[2]
            if way > LEAP + FASTEST * elapsed:
                self._seen = moment
                self._words = (
                    f'pedestrian {name[1]} jumped by {way:.1f} m within {elapsed:.2f} s: '
                    'does the tracker give one id to several people?'
                )
        fastest = max((speed_of(one) for one in lists), default=0.0)
        if fastest > FASTEST:
            self._seen = moment
            self._words = (
                f'a pedestrian at {fastest:.0f} m/s, taken to stand: '
                'does the tracker join different people?'
            )
        self._places = places

    def complaint(self, moment: float) -> str | None:
        """
        Return what was wrong lately, or None.

        :param moment: on a clock that always runs, s.
        """
        return self._words if moment - self._seen < TOLD else None


def places_of(lists: Sequence[AgentStates]) -> Places:
    """Return x, y and time, m and s, of everybody whose id is no other's, by source and id."""
    places: Places = {}
    twice = set()
    for told in lists:
        time = nanoseconds_of(told.header.stamp) * 1e-9
        for agent in told.agents:
            name = told.source, agent.id
            if name in places:
                twice.add(name)
            places[name] = agent.position.x, agent.position.y, time
    return {name: place for name, place in places.items() if name not in twice}


def speed_of(told: AgentStates) -> float:
    """Return the largest speed of a list, m/s."""
    return max((math.hypot(one.velocity.x, one.velocity.y) for one in told.agents), default=0.0)


def believed(state: CrowdState) -> CrowdState:
    """Return a state in which whoever is faster than anybody runs stands: it will not be there."""
    velocity = state.agents.velocity
    impossible = np.hypot(velocity[..., 0], velocity[..., 1]) > FASTEST
    if not impossible.any():
        return state
    return state.with_agents(velocity=np.where(impossible[..., None], 0.0, velocity))
