"""The speeds of an action set."""

import math

import numpy as np


def exponential_speeds(count: int) -> np.ndarray:
    """Return speeds up to 1 m/s that lie densest near 0, (exp(i / n) - 1) / (e - 1), (count,)."""
    return np.expm1(np.arange(1, count + 1) / count) / math.expm1(1.0)
