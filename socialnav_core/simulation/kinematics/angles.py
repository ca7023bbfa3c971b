"""Angles and the vectors that they turn."""

import math

import numpy as np


def direction(angle: np.ndarray) -> np.ndarray:
    """Return unit vectors along angles in rad, (..., 2)."""
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def wrap(angle: np.ndarray) -> np.ndarray:
    """Return angles in rad brought into [-pi, pi)."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def rotated(vector: np.ndarray, angle: float) -> np.ndarray:
    """Return one vector, (2,), turned counter-clockwise by an angle in rad."""
    cosine, sine = math.cos(angle), math.sin(angle)
    x, y = vector.tolist()
    return np.array([cosine * x - sine * y, sine * x + cosine * y])
