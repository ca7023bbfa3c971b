"""The trace of every episode: how it ended, and what happened in each of its steps."""

import dataclasses

import numpy as np

from socialnav_core.simulation import Outcome


@dataclasses.dataclass(frozen=True)
class EpisodeRecords:
    """
    Some episodes, a row each, in the order of their cases.

    A world has `states` = steps + 1 states, the start first. Arrays are as wide as the longest
    episode; what lies behind the end of a shorter one is NaN.
    """

    case_index: np.ndarray
    """Which case it was, int64 (episodes,)."""
    outcome: np.ndarray
    """How it ended, codes of Outcome, int8 (episodes,)."""
    time: np.ndarray
    """When it ended, s, (episodes,)."""
    path_length: np.ndarray
    """How far the robot drove, m, (episodes,)."""
    minimum_clearance: np.ndarray
    """Least gap to any agent, m, (episodes,); negative in a collision, inf without agents."""
    steps: np.ndarray
    """Number of decisions, int64 (episodes,)."""
    straight_path: np.ndarray
    """Straight way from the start to where the goal counts as reached, m, (episodes,)."""
    moment: np.ndarray
    """Time of each state, s, (episodes, states)."""
    position: np.ndarray
    """Where the robot was, m, (episodes, states, 2)."""
    velocity: np.ndarray
    """How it moved, m/s, (episodes, states, 2)."""
    command: np.ndarray
    """What the policy chose, as in Policy.act, (episodes, steps, 2)."""
    clearance: np.ndarray
    """Least gap to any agent during each step, m, (episodes, steps); inf without agents."""
    pedestrian_clearance: np.ndarray
    """Least gap to a pedestrian during each step, m, (episodes, steps); inf without any."""
    time_to_collision: np.ndarray
    """
    Time after each step until the robot would touch a pedestrian if all kept their velocities,
    s, (episodes, steps); inf where that never happens.
    """
    foreseen_distance: np.ndarray
    """
    Least distance of centres between the robot before each step and where visible people would be
    after one to FORESEEN_STEPS steps, m, (episodes, steps); inf without any, NaN: not asked.
    """
    bound: np.ndarray
    """Time of the fastest path that is known, s, (episodes,); inf: none found, NaN: not asked."""
    comfortable_bound: np.ndarray
    """The same for paths that keep the comfort distance to people."""

    @property
    def success(self) -> np.ndarray:
        """Return which episodes ended at the goal, bool (episodes,)."""
        return self.outcome == Outcome.GOAL

    @property
    def duration(self) -> np.ndarray:
        """Return how long each step took, s, (episodes, steps)."""
        return np.diff(self.moment, axis=1)

    @property
    def displacement(self) -> np.ndarray:
        """Return how far the robot came in each step, m, (episodes, steps, 2)."""
        return np.diff(self.position, axis=1)
