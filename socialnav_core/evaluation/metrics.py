"""What is measured in episodes, and the figures that sum it up."""

import dataclasses
import math
from typing import Any

import numpy as np

from socialnav_core.simulation import Outcome

INTRUSION_DISTANCE = 0.2
"""Gap to a pedestrian below which a step counts as an intrusion, m."""

COLLISIONS = (Outcome.COLLISION_PEDESTRIAN, Outcome.COLLISION_OBSTACLE, Outcome.OUT_OF_BOUNDS)


@dataclasses.dataclass(frozen=True)
class EpisodeRecords:
    """How each of some episodes went; arrays (episodes,), in the order of the cases."""

    case_index: np.ndarray
    """Which case it was, int64."""
    outcome: np.ndarray
    """How it ended, codes of Outcome, int8."""
    time: np.ndarray
    """When it ended, s."""
    path_length: np.ndarray
    """How far the robot drove, m."""
    minimum_clearance: np.ndarray
    """Least gap to any agent, m; negative in a collision, inf where there are no agents."""
    steps: np.ndarray
    """Number of decisions, int64."""
    intrusions: np.ndarray
    """Number of steps with less than INTRUSION_DISTANCE to a pedestrian, int64."""

    @property
    def success(self) -> np.ndarray:
        """Return which episodes ended at the goal, bool."""
        return self.outcome == Outcome.GOAL

    def rate(self, *outcomes: Outcome) -> float:
        """
        Return the share of episodes that ended in one of the outcomes.

        :param outcomes: which ones.
        """
        return float(np.isin(self.outcome, outcomes).mean())


def empty_records(cases: np.ndarray) -> EpisodeRecords:
    """
    Return records of episodes that have not been run.

    :param cases: their indices, (episodes,).
    """
    count = len(cases)
    whole, real = np.zeros(count, np.int64), np.full(count, np.nan)
    return EpisodeRecords(
        case_index=np.asarray(cases, np.int64),
        outcome=np.full(count, Outcome.NONE, np.int8),
        time=real,
        path_length=real.copy(),
        minimum_clearance=real.copy(),
        steps=whole,
        intrusions=whole.copy(),
    )


def summarise(records: EpisodeRecords) -> dict[str, float | None]:
    """
    Return the rates and means of some episodes; a mean over nothing is None.

    Times and path lengths are averaged over successes, clearances over all episodes that met
    anybody. The rates of success, collision (walls included) and time-out add up to one.

    :param records: at least one episode.
    """
    success = records.success
    return {
        'success_rate': float(success.mean()),
        'collision_rate': records.rate(*COLLISIONS),
        'collision_pedestrian_rate': records.rate(Outcome.COLLISION_PEDESTRIAN),
        'collision_obstacle_rate': records.rate(Outcome.COLLISION_OBSTACLE),
        'out_of_bounds_rate': records.rate(Outcome.OUT_OF_BOUNDS),
        'timeout_rate': records.rate(Outcome.TIMEOUT),
        'navigation_time_mean': mean_or_none(records.time[success]),
        'path_length_mean': mean_or_none(records.path_length[success]),
        'minimum_clearance_mean': mean_or_none(records.minimum_clearance),
        'intrusion_rate': float(records.intrusions.sum() / records.steps.sum()),
    }


def case_mappings(records: EpisodeRecords) -> list[dict[str, Any]]:
    """
    Return a mapping of plain values for each episode, fit for JSON.

    :param records: the episodes.
    """
    shares = records.intrusions / records.steps
    return [
        {
            'case_index': int(records.case_index[i]),
            'outcome': outcome_name(records.outcome[i]),
            'time': float(records.time[i]),
            'path_length': float(records.path_length[i]),
            'minimum_clearance': finite_or_none(records.minimum_clearance[i]),
            'steps': int(records.steps[i]),
            'intrusion_rate': float(shares[i]),
        }
        for i in range(len(records.case_index))
    ]


def outcome_name(outcome: int) -> str:
    """
    Return the name of an outcome as it stands in files, such as goal or collision_obstacle.

    :param outcome: a code of Outcome.
    """
    return Outcome(int(outcome)).name.lower()


def mean_or_none(values: np.ndarray) -> float | None:
    """
    Return the mean of the finite values, None where there are none.

    :param values: any shape.
    """
    finite = values[np.isfinite(values)]
    return float(finite.mean()) if finite.size else None


def finite_or_none(value: float) -> float | None:
    """
    Return a finite number, None for another one: JSON has no infinity.

    :param value: any number.
    """
    return float(value) if math.isfinite(value) else None
