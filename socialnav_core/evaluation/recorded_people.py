"""Recorded pedestrians as predictions are judged on them; config/recordings.py reads them."""

from collections.abc import Iterator

import numpy as np

from socialnav_core.config.recordings import INTERVAL as TIME_STEP
from socialnav_core.evaluation.judgement import Moment, TIMES
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_core.training.prediction.recording import FAR

RADIUS = 0.3  # m


def track_moments(tracks: np.ndarray) -> Iterator[Moment]:
    """
    Yield what is seen in each frame, and the truth.

    Velocities are what somebody could measure by then: differences to the frame before. Whoever
    was not in it is not there yet.
    """
    known = np.isfinite(tracks).all(axis=2)
    people = tracks.shape[1]
    exact = TIMES / TIME_STEP
    before = np.floor(exact + 1e-9).astype(int)
    share = np.maximum(exact - before, 0.0)[:, None, None]
    share[share < 1e-6] = 0.0
    after = before + (share[:, 0, 0] > 0)
    for frame in range(1, len(tracks) - after.max()):
        valid = known[frame] & known[frame - 1]
        velocity = np.where(valid[:, None], (tracks[frame] - tracks[frame - 1]) / TIME_STEP, 0.0)
        position = np.where(valid[:, None], tracks[frame], 0.0)
        agents = Agents(
            position[None], velocity[None], np.full((1, people), RADIUS),
            np.zeros((1, people), bool), valid[None],
        )  # fmt: skip
        truth = (1.0 - share) * tracks[frame + before] + share * tracks[frame + after]
        yield (
            CrowdState(far_robot(), agents, np.array([np.inf]), np.array([frame * TIME_STEP])),
            (truth[None]),
        )


def far_robot() -> Robot:
    """Return a robot that nobody minds."""
    one, place = np.ones(1), np.full((1, 2), FAR)
    return Robot(place, np.zeros((1, 2)), np.zeros(1), one, one, place)
