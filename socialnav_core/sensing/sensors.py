"""A laser scanner and a detector of people, simulated with their faults."""

import dataclasses
from typing import Annotated

import numpy as np

from socialnav_core.config.ranges import Range, require_allowed
from socialnav_core.sensing.ray_casting import beam_angles, cast_rays
from socialnav_core.states import CrowdState

SCANNING, DETECTING = 0, 1
"""Purposes of random streams, which do not disturb each other."""


@dataclasses.dataclass(frozen=True)
class ScannerSettings:
    """A laser scanner at the centre of the robot that sees all around."""

    beams: Annotated[int, Range(1, 100_000)] = 360
    """Number of beams, the first one pointing backwards."""
    range: Annotated[float, Range(0.01, 1000)] = 10.0
    """Longest range, m."""
    noise: Annotated[float, Range(0, 10)] = 0.0
    """Standard deviation of a range, m."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class DetectorSettings:
    """A detector of pedestrians that knows neither who they are nor how fast they walk."""

    noise: Annotated[float, Range(0, 10)] = 0.0
    """Standard deviation of a position along each axis, m."""
    missed: Annotated[float, Range(0, 1)] = 0.0
    """Probability that a pedestrian is missed."""
    occlusion: bool = False
    """Whether only pedestrians whom some beam of the scanner reaches are detected."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


class Sensors:
    """The sensors of one robot; the same seed and case give the same faults."""

    def __init__(
        self, scanner: ScannerSettings, detector: DetectorSettings, seed: int, case: int
    ) -> None:
        """Begin an episode, with the noise of a seed and case."""
        self.scanner, self.detector = scanner, detector
        self._scanning, self._detecting = (
            np.random.default_rng([seed, case, purpose]) for purpose in (SCANNING, DETECTING)
        )

    def scan(self, state: CrowdState) -> np.ndarray:
        """Return the range of each beam in the first world, m, inf where it is free, (beams,)."""
        ranges = self._cast(state)[0]
        noisy = ranges + self.scanner.noise * self._scanning.standard_normal(len(ranges))
        return np.where(ranges <= self.scanner.range, np.maximum(noisy, 0.0), np.inf)

    def detect(self, state: CrowdState) -> np.ndarray:
        """
        Return where pedestrians are seen, in an order that tells nothing, m, (detections, 2).

        :param state: its first world is looked at.
        """
        walking = np.flatnonzero(state.agents.valid[0] & ~state.agents.static[0])
        position = state.agents.position[0, walking]
        position = position + self.detector.noise * self._detecting.standard_normal(position.shape)
        seen = self._detecting.random(len(walking)) >= self.detector.missed
        order = self._detecting.permutation(len(walking))
        if self.detector.occlusion:
            seen &= np.isin(walking, self._visible(state))
        return position[order[seen[order]]]

    def _visible(self, state: CrowdState) -> np.ndarray:
        """Return the agents that some beam reaches, as indices."""
        ranges, hit = self._cast(state)
        real = np.flatnonzero(state.agents.valid[0])
        return real[np.unique(hit[(hit >= 0) & (ranges <= self.scanner.range)])]

    def _cast(self, state: CrowdState) -> tuple[np.ndarray, np.ndarray]:
        """Return true ranges, and what is hit among the valid agents."""
        angles = state.robot.heading[0] + beam_angles(self.scanner.beams)
        real, agents = state.agents.valid[0], state.agents
        return cast_rays(
            state.robot.position[0], angles, agents.position[0, real], agents.radius[0, real],
            float(state.bounds[0]),
        )  # fmt: skip
