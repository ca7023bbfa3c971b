"""Episodes put together again from what was published."""

import math
from typing import Any

import numpy as np

from socialnav.messages.conversions import crowd_state, RobotBody
from socialnav.messages.stamps import nanoseconds_of
from socialnav_core.simulation import make_scenario
from socialnav_core.states import CrowdState
from socialnav_msgs.msg import EpisodeResult


class EpisodeRecorder:
    """Keeps messages by their time until one good episode is complete."""

    def __init__(self) -> None:
        self._messages: dict[str, dict[int, Any]] = {
            name: {} for name in ('odom', 'pedestrians', 'obstacles', 'goal_pose')
        }
        self._results: list[EpisodeResult] = []
        self._wanted_until = math.inf
        self._latest = 0

    def store(self, name: str, message: Any) -> bool:
        """
        Keep a message unless a good episode is there already; return whether time went on.

        :param message: it has a header.
        """
        stamp = nanoseconds_of(message.header.stamp)
        if stamp <= self._wanted_until:
            self._messages[name][stamp] = message
        progress = stamp > self._latest
        self._latest = max(stamp, self._latest)
        return progress

    def store_result(self, result: EpisodeResult) -> None:
        """Keep how an episode ended."""
        self._results.append(result)
        if result.outcome == 'goal':
            end = nanoseconds_of(result.header.stamp)
            self._wanted_until = min(self._wanted_until, end)

    def good_episode(self) -> tuple[EpisodeResult, list[CrowdState]] | None:
        """Return the first episode that reached its goal, else the first; None without a state."""
        for result in sorted(self._results, key=lambda result: result.outcome != 'goal'):
            states = self._states(result)
            if states:
                return result, states
        return None

    def _states(self, result: EpisodeResult) -> list[CrowdState]:
        """Return the states of an episode in the order of time."""
        end = nanoseconds_of(result.header.stamp)
        ends = [nanoseconds_of(other.header.stamp) for other in self._results]
        begin = max((other for other in ends if other < end), default=0)
        stamps = sorted(self._messages['odom'].keys() & self._messages['pedestrians'].keys())
        stamps = [stamp for stamp in stamps if begin < stamp <= end]
        states = (self._state(stamp, stamps[0], result.scenario) for stamp in stamps)
        return [state for state in states if state is not None]

    def _state(self, stamp: int, start: int, scenario_name: str) -> CrowdState | None:
        """Return the state of a moment; None where its goal or obstacles did not come."""
        goal, obstacles = (
            latest(self._messages[name], stamp) for name in ('goal_pose', 'obstacles')
        )
        if goal is None or obstacles is None:
            return None
        scenario = make_scenario(scenario_name)
        body = RobotBody(scenario.robot_radius, scenario.robot_preferred_speed, scenario.bounds)
        odometry, pedestrians = (self._messages[name][stamp] for name in ('odom', 'pedestrians'))
        frame, time = odometry.header.frame_id, (stamp - start) * 1e-9
        return crowd_state(odometry, goal, pedestrians, obstacles, body, frame, time)


def latest(messages: dict[int, Any], stamp: int) -> Any:
    """
    Return the newest message that is not newer than a moment, or None.

    :param messages: by time, ns.
    :param stamp: the moment, ns.
    """
    earlier = [time for time in messages if time <= stamp]
    return messages[max(earlier)] if earlier else None


def cause(state: CrowdState) -> str:
    """
    Return which kind of collision a state shows.

    :param state: batch of one, at the end of the episode.
    """
    offset = state.agents.position[0] - state.robot.position[0]
    gap = np.hypot(offset[:, 0], offset[:, 1]) - state.agents.radius[0]
    return 'collision_obstacle' if state.agents.static[0, gap.argmin()] else 'collision_pedestrian'
