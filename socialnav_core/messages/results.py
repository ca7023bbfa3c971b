"""How an episode ended."""

import dataclasses

from socialnav_core.messages.parts import header, Message

COARSE_OUTCOMES = {'collision_pedestrian': 'collision', 'collision_obstacle': 'collision'}
"""Outcomes that messages call otherwise."""


@dataclasses.dataclass(frozen=True)
class EpisodeEnd:
    """The fields of a socialnav_msgs/EpisodeResult but for the header."""

    scenario: str
    """Name of the world."""
    seed: int
    """Seed of the cases."""
    case_index: int
    """Which case it was."""
    outcome: str
    """goal, collision_pedestrian, collision_obstacle, out_of_bounds or timeout."""
    time: float
    """Duration, s."""
    path_length: float
    """Way that the robot went, m."""
    minimum_clearance: float
    """Least gap to any agent, m; inf where there was none."""
    steps: int
    """Number of steps of the simulation."""


def episode_result(end: EpisodeEnd, nanoseconds: int, frame: str) -> Message:
    """Return how an episode ended as a socialnav_msgs/EpisodeResult."""
    outcome = COARSE_OUTCOMES.get(end.outcome, end.outcome)
    return {
        'header': header(nanoseconds, frame), **dataclasses.asdict(end), 'outcome': outcome,
    }  # fmt: skip
