"""Where one frame lies in another, and who may be asked for it."""

from collections.abc import Callable
import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Placement:
    """Where the origin of a frame lies in another, and how it is turned."""

    x: float = 0.0
    """m."""
    y: float = 0.0
    """m."""
    heading: float = 0.0
    """rad."""

    @property
    def rotation(self) -> np.ndarray:
        """Return the matrix that turns a row of vectors, (2, 2)."""
        cosine, sine = np.cos(self.heading), np.sin(self.heading)
        return np.array([[cosine, sine], [-sine, cosine]])

    def turned(self, vectors: np.ndarray) -> np.ndarray:
        """
        Return vectors of the inner frame as the outer has them, (..., 2).

        :param vectors: velocities, (..., 2).
        """
        return vectors if self == HERE else vectors @ self.rotation

    def placed(self, points: np.ndarray) -> np.ndarray:
        """
        Return points of the inner frame as the outer has them, (..., 2).

        :param points: m, (..., 2).
        """
        return points if self == HERE else points @ self.rotation + (self.x, self.y)

    def found(self, points: np.ndarray) -> np.ndarray:
        """
        Return points of the outer frame as the inner has them, (..., 2).

        :param points: m, (..., 2).
        """
        return (points - (self.x, self.y)) @ self.rotation.T

    def within(self, outer: 'Placement') -> 'Placement':
        """
        Return where the inner frame lies in a third one.

        :param outer: where the outer frame lies in it.
        """
        x, y = outer.placed(np.array([self.x, self.y])).tolist()
        return Placement(x, y, self.heading + outer.heading)


HERE = Placement()

Locate = Callable[[str, str, int], Placement]
"""
Says where a frame (second) lies in another (first) at a time (third, ns; 0 for the newest known).

Raises LookupError, whose text says what is missing.
"""


def not_asked(frame: str, source: str, stamp: int) -> Placement:
    """
    Refuse, where all inputs must be in one frame.

    :param frame: the frame that is wanted.
    :param source: the frame that an input is in.
    :param stamp: time of the input, ns.
    """
    raise LookupError(f'everything must be in {frame!r}')
