"""From positions without names to tracks: assignment within gates, a Kalman filter for each."""

import dataclasses
from typing import Annotated

import numpy as np
from scipy.optimize import linear_sum_assignment

from socialnav_core.config.ranges import Range, require_allowed

FORBIDDEN = 1e6
"""Cost of an assignment beyond the gate: any number of others is cheaper."""
MOST_TRACKS = 1000
"""The oldest tracks beyond this number are dropped, so that time and memory have an end."""
ROUNDING = 1e-6
"""What times may differ by, s."""


@dataclasses.dataclass(frozen=True)
class TrackerSettings:
    """Constant velocity with white noise of acceleration (Bar-Shalom et al. 2001, 6.2.2)."""

    acceleration_noise: Annotated[float, Range(0.001, 100)] = 0.5
    """Power spectral density of the acceleration, m^2/s^3."""
    detection_noise: Annotated[float, Range(0.001, 2)] = 0.05
    """Standard deviation of a detection along each axis, m."""
    start_speed: Annotated[float, Range(0.01, 10)] = 1.0
    """Standard deviation of the velocity of a new track along each axis, m/s."""
    gate: Annotated[float, Range(0.1, 100)] = 4.0
    """Detections farther than so many standard deviations are not a track's."""
    coast_time: Annotated[float, Range(0, 3600)] = 0.5
    """Time without a detection after which a track dies, s."""
    confirmation_time: Annotated[float, Range(0, 10)] = 0.04
    """Time between first and newest detection that confirms a track, s; 0: one is enough."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class Tracks:
    """Who is there."""

    id: np.ndarray
    """Number that stays with a person, int (tracks,)."""
    position: np.ndarray
    """m, (tracks, 2)."""
    velocity: np.ndarray
    """m/s, (tracks, 2); 0 for who is not confirmed."""
    confirmed: np.ndarray
    """Who has been detected for long enough, bool (tracks,)."""


class Tracker:
    """All tracks at one time; the arrays of the filters have the track as their first axis."""

    def __init__(self, settings: TrackerSettings) -> None:
        """
        Start without a track.

        :param settings: may be replaced at any time.
        """
        self.settings = settings
        self._next_id = 0
        self._time = -np.inf
        self._forget()

    def update(self, time: float, detections: np.ndarray) -> Tracks:
        """
        Take the detections of a moment and return all tracks.

        :param time: of the detections, s; when it runs backwards, all tracks are forgotten.
        :param detections: m, (detections, 2).
        """
        if time < self._time:
            self._forget()
        self._keep(time - self._seen <= self.settings.coast_time)
        if len(self._id):
            self._predict(time - self._time)
        self._time = time
        tracks, matched = self._assign(detections)
        self._correct(tracks, detections[matched])
        self._begin(np.delete(detections, matched, axis=0))
        self._keep(np.arange(len(self._id)) >= len(self._id) - MOST_TRACKS)
        confirmed = self._seen - self._born >= self.settings.confirmation_time - ROUNDING
        position, velocity = np.split(self._mean, 2, axis=1)
        velocity = np.where(confirmed[:, None], velocity, 0.0)
        return Tracks(self._id, position, velocity, confirmed)

    def _forget(self) -> None:
        """Drop all tracks."""
        self._id = np.zeros(0, int)
        self._born, self._seen = np.zeros(0), np.zeros(0)
        self._mean, self._covariance = np.zeros((0, 4)), np.zeros((0, 4, 4))

    def _keep(self, kept: np.ndarray) -> None:
        """Drop tracks but those of a mask."""
        self._id, self._born, self._seen, self._mean, self._covariance = (
            array[kept]
            for array in (self._id, self._born, self._seen, self._mean, self._covariance)
        )

    def _predict(self, duration: float) -> None:
        """Move all tracks forward in time."""
        step = np.eye(4) + duration * np.eye(4, k=2)
        # covariance that white noise of the acceleration adds to position and velocity
        spread = np.array([[duration**3 / 3, duration**2 / 2], [duration**2 / 2, duration]])
        self._mean = self._mean @ step.T
        self._covariance = step @ self._covariance @ step.T + np.kron(
            self.settings.acceleration_noise * spread, np.eye(2)
        )

    def _assign(self, detections: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the tracks that were detected and the detection of each, as indices."""
        if not len(self._id) or not len(detections):
            return np.zeros(0, int), np.zeros(0, int)
        surprise = detections - self._mean[:, None, :2]  # (tracks, detections, 2)
        precision = inverse(self._expected_spread(self._covariance))
        cost = np.einsum('tdi,tij,tdj->td', surprise, precision, surprise)
        cost = np.where(cost <= self.settings.gate**2, cost, FORBIDDEN)
        tracks, matched = linear_sum_assignment(cost)
        near = cost[tracks, matched] < FORBIDDEN
        return tracks[near], matched[near]

    def _correct(self, tracks: np.ndarray, detections: np.ndarray) -> None:
        """Let tracks take their detections into account."""
        covariance = self._covariance[tracks]
        gain = covariance[:, :, :2] @ inverse(self._expected_spread(covariance))
        surprise = detections - self._mean[tracks, :2]
        self._mean[tracks] += np.einsum('tij,tj->ti', gain, surprise)
        self._covariance[tracks] = covariance - gain @ covariance[:, :2]
        self._seen[tracks] = self._time

    def _begin(self, detections: np.ndarray) -> None:
        """Begin a track at each detection."""
        count, settings = len(detections), self.settings
        variances = np.repeat([settings.detection_noise, settings.start_speed], 2) ** 2
        covariance = np.broadcast_to(np.diag(variances), (count, 4, 4))
        self._id = np.concatenate([self._id, self._next_id + np.arange(count)])
        self._born = np.concatenate([self._born, np.full(count, self._time)])
        self._seen = np.concatenate([self._seen, np.full(count, self._time)])
        self._mean = np.concatenate([self._mean, np.pad(detections, ((0, 0), (0, 2)))])
        self._covariance = np.concatenate([self._covariance, covariance])
        self._next_id += count

    def _expected_spread(self, covariance: np.ndarray) -> np.ndarray:
        """Return the covariance of what will be measured, (tracks, 2, 2)."""
        return covariance[:, :2, :2] + self.settings.detection_noise**2 * np.eye(2)


def inverse(matrices: np.ndarray) -> np.ndarray:
    """
    Return the inverses of matrices of two rows.

    The library's inverse waits for other threads, on a busy computer for tens of milliseconds.

    :param matrices: symmetric and positive, (matrices, 2, 2).
    """
    (a, b), (c, d) = matrices[:, 0].T, matrices[:, 1].T
    adjugate = np.stack([d, -b, -c, a], axis=-1).reshape(-1, 2, 2)
    return adjugate / (a * d - b * c)[:, None, None]
