"""What was seen of the agents in the last seconds, and their motions at fixed lags."""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.prediction.learned.layout import LAG, LAGS, MOTION
from socialnav_core.states import CrowdState

SAMPLES = 16
"""Samples kept of each world; they reach back LAGS * LAG seconds at least."""
SPACING = 0.1
"""Samples nearer than this to an older one are not kept, s."""
LONGEST_GAP = 0.6
"""After a longer gap between two samples the older ones are forgotten, s."""
TOLERANCE = 1e-6  # times are sums of time steps


class History:
    """
    The last motions of each agent in each world, newest first: velocity, then position.

    Agents are told apart by identities. Times tell the steps: whoever asks twice at the same time
    adds nothing, and a world whose time jumps back has started again.
    """

    def __init__(self) -> None:
        self.times = np.empty((0, SAMPLES))
        self.motions = np.empty((0, SAMPLES, 0, MOTION))
        self.seen = np.empty((0, SAMPLES, 0), bool)
        self.identities = np.empty((0, 0), np.int64)

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget some worlds, by indices or a mask; None for all."""
        self.times[slice(None) if worlds is None else worlds] = -math.inf

    def update(self, state: CrowdState, identities: np.ndarray | None = None) -> None:
        """
        Add what is seen now.

        :param identities: whole numbers that stay with an agent whatever its slot is,
            (batch, agents); None where agents keep their slots.
        """
        agents = state.agents
        shape = (state.batch_size, agents.count)
        if identities is None:
            identities = np.broadcast_to(np.arange(agents.count), shape)
        if self.times.shape[0] != state.batch_size:
            self._begin(shape, identities)
        if self.identities.shape != shape or (self.identities != identities).any():
            self._follow(identities)
        motion = np.concatenate([agents.velocity, agents.position], axis=2)
        add_samples(state.time, motion, agents.valid, self.times, self.motions, self.seen)

    def lagged(self) -> tuple[np.ndarray, np.ndarray]:
        """
        Return the motions LAG, 2 LAG, ... ago and whether they are known, now first.

        Shapes are (batch, LAGS, agents, MOTION) and (batch, LAGS, agents).
        """
        return lagged_motions(self.times, self.motions, self.seen)

    def _begin(self, shape: tuple[int, int], identities: np.ndarray) -> None:
        """Make room for worlds of which nothing is known."""
        batch, agents = shape
        self.times = np.full((batch, SAMPLES), -math.inf)
        self.motions = np.zeros((batch, SAMPLES, agents, MOTION))
        self.seen = np.zeros((batch, SAMPLES, agents), bool)
        self.identities = identities.copy()

    def _follow(self, identities: np.ndarray) -> None:
        """Move what is known of each agent to the slot that it has now."""
        same = identities[:, :, None] == self.identities[:, None]
        known = same.any(axis=2)
        origin = same.argmax(axis=2) if self.identities.shape[1] else np.zeros(known.shape, int)
        self.identities = identities.copy()
        if not self.seen.shape[2]:
            self._begin((len(identities), identities.shape[1]), identities)
            return
        self.motions = np.take_along_axis(self.motions, origin[:, None, :, None], axis=2)
        self.seen = np.take_along_axis(self.seen, origin[:, None], axis=2) & known[:, None]


@compiled
def add_samples(time, motion, valid, times, motions, seen):  # type: ignore[no-untyped-def]
    """
    Put the present motions in front of the samples of each world, in place.

    The newest sample is always that of now; it gives way to the next unless SPACING lies between
    it and the one before.

    :param time: s, (batch,).
    :param motion: velocity and position, (batch, agents, MOTION).
    :param valid: (batch, agents).
    :param times: s, newest first, -inf where there is none, (batch, samples).
    :param motions: velocities and positions, (batch, samples, agents, MOTION).
    :param seen: whether the agent was there, (batch, samples, agents).
    """
    samples = times.shape[1]
    for world in range(times.shape[0]):
        now, newest = time[world], times[world, 0]
        if now < newest - TOLERANCE or now > newest + LONGEST_GAP:
            times[world] = -np.inf
        same = abs(now - newest) <= TOLERANCE
        if not same and newest - times[world, 1] >= SPACING - TOLERANCE:
            for sample in range(samples - 1, 0, -1):
                times[world, sample] = times[world, sample - 1]
                motions[world, sample] = motions[world, sample - 1]
                seen[world, sample] = seen[world, sample - 1]
        times[world, 0] = now
        motions[world, 0] = motion[world]
        seen[world, 0] = valid[world]


@compiled
def lagged_motions(times, motions, seen):  # type: ignore[no-untyped-def]
    """
    Return the motions at fixed lags, linear between samples, and whether they are known.

    :param times: s, newest first, -inf where there is no sample, (batch, samples).
    :param motions: velocities and positions, (batch, samples, agents, MOTION).
    :param seen: whether the agent was there, (batch, samples, agents).
    """
    batch, samples, agents = seen.shape
    lagged = np.zeros((batch, LAGS, agents, MOTION))
    known = np.zeros((batch, LAGS, agents), np.bool_)
    for world in range(batch):
        newer = 0
        for lag in range(LAGS):
            moment = times[world, 0] - lag * LAG
            while newer < samples - 1 and times[world, newer + 1] > moment - TOLERANCE:
                newer += 1
            # the sample `newer` is the oldest that is not before the moment
            older, share = newer, 0.0
            if times[world, newer] > moment + TOLERANCE:
                older = newer + 1
                if older >= samples or times[world, older] == -np.inf:
                    break
                gap = times[world, newer] - times[world, older]
                share = (times[world, newer] - moment) / gap
            for agent in range(agents):
                if seen[world, newer, agent] and seen[world, older, agent]:
                    known[world, lag, agent] = True
                    for part in range(MOTION):
                        lagged[world, lag, agent, part] = (1.0 - share) * motions[
                            world, newer, agent, part
                        ] + share * motions[world, older, agent, part]
    return lagged, known
