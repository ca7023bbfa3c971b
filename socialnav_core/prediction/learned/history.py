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
SURE, SURE_SPEED, LARGEST_SPEED = 0.3, 0.5, 2.5
"""
Who is within SURE, m, and the way at SURE_SPEED, m/s, of where the person of their slot would be
is that person. Who is within the way at LARGEST_SPEED of another one's may be that other one.
"""


class History:
    """
    The last motions of each agent in each world, newest first: velocity, then position.

    Agents are told apart by where they are: slots may change, and whoever is not where somebody
    could have walked to is new. Times tell the steps: whoever asks twice at the same time adds
    nothing, and a world whose time jumps back has started again.
    """

    def __init__(self) -> None:
        self.times = np.empty((0, SAMPLES))
        self.motions = np.empty((0, SAMPLES, 0, MOTION))
        self.seen = np.empty((0, SAMPLES, 0), bool)

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget some worlds, by indices or a mask; None for all."""
        self.times[slice(None) if worlds is None else worlds] = -math.inf

    def update(self, state: CrowdState) -> None:
        """Add what is seen now."""
        agents = state.agents
        batch, count = agents.valid.shape
        if self.times.shape[0] != batch:
            self.times = np.full((batch, SAMPLES), -math.inf)
            self.motions = np.zeros((batch, SAMPLES, count, MOTION))
            self.seen = np.zeros((batch, SAMPLES, count), bool)
        motion = np.concatenate([agents.velocity, agents.position], axis=2)
        walking = agents.valid & ~agents.static
        before = former_slots(state.time, motion, walking, self.times, self.motions, self.seen)
        if count != self.seen.shape[2] or (before != np.arange(count)).any():
            self._follow(before)
        add_samples(state.time, motion, walking, self.times, self.motions, self.seen)

    def lagged(self) -> tuple[np.ndarray, np.ndarray]:
        """
        Return the motions LAG, 2 LAG, ... ago and whether they are known, now first.

        Shapes are (batch, LAGS, agents, MOTION) and (batch, LAGS, agents).
        """
        return lagged_motions(self.times, self.motions, self.seen)

    def _follow(self, before: np.ndarray) -> None:
        """Move what is known of each agent to its slot from the one before, (batch, agents)."""
        batch, count = before.shape
        motions = np.zeros((batch, SAMPLES, count, MOTION))
        seen = np.zeros((batch, SAMPLES, count), bool)
        world, slot = np.nonzero(before >= 0)
        motions[world, :, slot] = self.motions[world, :, before[world, slot]]
        seen[world, :, slot] = self.seen[world, :, before[world, slot]]
        self.motions, self.seen = motions, seen


@compiled
def former_slots(time, motion, walking, times, motions, seen):  # type: ignore[no-untyped-def]
    """
    Return the slot that each agent had before, -1 for who is new, (batch, agents).

    Everybody was in the slot that they are in now if its person would be about there by now; else
    in the nearest one whose person could be there.

    :param time: s, (batch,).
    :param motion: velocity and position, (batch, agents, MOTION).
    :param walking: whether somebody is there who is no obstacle, (batch, agents).
    :param times: s, newest first, -inf where there is no sample, (batch, samples).
    :param motions: velocities and positions, (batch, samples, slots, MOTION).
    :param seen: whether somebody was there, (batch, samples, slots).
    """
    batch, agents, slots = walking.shape[0], walking.shape[1], seen.shape[2]
    before = np.full((batch, agents), -1)
    expected, age, taken = np.empty((slots, 2)), np.empty(slots), np.empty(slots, np.bool_)
    for world in range(batch):
        expect(time[world], times[world], motions[world], seen[world], expected, age)
        taken[:] = False
        for agent in range(min(agents, slots)):
            away = distance(motion[world, agent], expected[agent])
            if walking[world, agent] and away <= SURE + SURE_SPEED * age[agent] < np.inf:
                before[world, agent], taken[agent] = agent, True
        for agent in range(agents):
            if walking[world, agent] and before[world, agent] < 0:
                slot = nearest_slot(motion[world, agent], expected, age, taken)
                before[world, agent] = slot
                if slot >= 0:
                    taken[slot] = True
        for agent in range(min(agents, slots)):  # of who is not seen now, or was never seen here
            unseen = age[agent] == np.inf or not walking[world, agent]
            if before[world, agent] < 0 and unseen and not taken[agent]:
                before[world, agent] = agent
    return before


@compiled
def expect(time, times, motions, seen, expected, age):  # type: ignore[no-untyped-def]
    """Write where the person of each slot would be by now, m, and when it was seen, s ago."""
    for slot in range(seen.shape[1]):
        age[slot] = np.inf
        for sample in range(len(times)):
            if not time - times[sample] <= LONGEST_GAP:
                break
            if seen[sample, slot]:
                age[slot] = max(time - times[sample], 0.0)
                for axis in range(2):
                    expected[slot, axis] = (
                        motions[sample, slot, 2 + axis] + age[slot] * motions[sample, slot, axis]
                    )
                break


@compiled
def distance(motion, place):  # type: ignore[no-untyped-def]
    """Return how far somebody is from a place, m."""
    return math.sqrt((motion[2] - place[0]) ** 2 + (motion[3] - place[1]) ** 2)


@compiled
def nearest_slot(motion, expected, age, taken):  # type: ignore[no-untyped-def]
    """Return the nearest slot that is free and whose person could be here, or -1."""
    found, least = -1, np.inf
    for slot in range(len(age)):
        away = distance(motion, expected[slot])
        near = away <= SURE + LARGEST_SPEED * age[slot] < np.inf
        if near and not taken[slot] and away < least:
            found, least = slot, away
    return found


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
