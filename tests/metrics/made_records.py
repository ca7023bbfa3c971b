"""Records of episodes that nobody has driven."""

import numpy as np

from socialnav_core.metrics import EpisodeRecords


def make_records(outcomes, intrusions=None, **columns):
    """
    Return records of episodes that ended in some outcomes, for figures that need no trace.

    The robot stands still; in the first `intrusions` steps a pedestrian is too near.
    """
    count = len(outcomes)
    defaults = {
        'case_index': np.arange(count),
        'outcome': outcomes,
        'time': np.arange(1.0, count + 1),
        'path_length': np.arange(10.0, count + 10),
        'minimum_clearance': np.full(count, 0.5),
        'steps': np.full(count, 10),
        'straight_path': np.full(count, 8.0),
    }
    columns = {name: np.asarray(column) for name, column in (defaults | columns).items()}
    steps = columns['steps']
    step = np.arange(steps.max())
    near = np.zeros(count) if intrusions is None else np.asarray(intrusions)
    gap = np.where(step < near[:, None], 0.1, 1.0)
    gap[step >= steps[:, None]] = np.nan
    states = np.where(np.arange(steps.max() + 1) <= steps[:, None], 0.0, np.nan)
    return EpisodeRecords(
        **columns,
        moment=states + 0.25 * np.arange(steps.max() + 1),
        position=np.stack([states, states], axis=-1),
        velocity=np.stack([states, states], axis=-1),
        command=np.stack([gap, gap], axis=-1),
        clearance=gap,
        pedestrian_clearance=gap,
        time_to_collision=gap,
        foreseen_distance=np.full_like(gap, np.nan),
        bound=np.full(count, np.nan),
        comfortable_bound=np.full(count, np.nan),
    )
