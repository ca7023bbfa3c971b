"""People in a street: they walk on, alone or side by side, sway, stand about and set off."""

import numpy as np

from socialnav_core.simulation.cases import Episodes
from socialnav_core.training.prediction.recording import Recording

FAR = 100.0  # m; where those who walk on want to go
LARGEST_STANDING, FOREVER = 0.4, 0.5
"""Largest share of the people who stand at first, and the share of these who stay."""
LONGEST_WAIT = 15.0  # s
CROSSING_SHARE = 0.2
"""Share of the people who go across the street."""
LARGEST_COMPANY = 0.5
"""Largest share of the people who walk beside another one."""
SPACING, LARGEST_ERROR = (0.4, 2.0), 0.05
"""Of the marks that tracks are made from: time between two, s, and standard deviation, m."""
WANDERINGS = 3
"""Slow oscillations of a walk, which make its ways bend."""


def walk_along(episodes: Episodes, people: int, generator: np.random.Generator) -> np.ndarray:
    """
    Give people goals far along a street, in place; return how long each stands at first, s.

    The result is (worlds, people), inf for those who stay.
    """
    shape = (len(episodes.goal), people)
    street = generator.uniform(0.0, 2.0 * np.pi, (len(episodes.goal), 1))
    crossing = generator.random(shape) < CROSSING_SHARE
    angle = street + np.pi * generator.integers(0, 2, shape) + 0.5 * np.pi * crossing
    angle += 0.1 * generator.standard_normal(shape)
    way = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    episodes.goal[:, :people] = episodes.state.agents.position[:, :people] + FAR * way
    standing = generator.random(shape) < generator.uniform(0.0, LARGEST_STANDING)
    stays = generator.random(shape) < FOREVER
    wait = np.where(stays, np.inf, generator.uniform(0.0, LONGEST_WAIT, shape))
    return np.where(standing, wait, 0.0)


def with_company(recording: Recording, generator: np.random.Generator) -> Recording:
    """Return a recording in which some people walk beside another one."""
    shape = (recording.worlds, recording.people)
    beside = generator.random(shape) < generator.uniform(0.0, LARGEST_COMPANY)
    angle = generator.uniform(0.0, 2.0 * np.pi, shape)
    distance = generator.uniform(0.45, 0.9, shape)
    offset = (distance * np.array([np.cos(angle), np.sin(angle)])).transpose(1, 2, 0)
    for person in range(1, recording.people):
        worlds = beside[:, person]
        for array in (recording.position, recording.goal):
            array[worlds, :, person] = array[worlds, :, person - 1] + offset[worlds, None, person]
        recording.velocity[worlds, :, person] = recording.velocity[worlds, :, person - 1]
    return recording


def as_tracked(recording: Recording, generator: np.random.Generator) -> Recording:
    """
    Return a recording with the gait of people and the errors of those who mark where they are.

    Velocities are what can be measured then: differences to the moment before.
    """
    position = smoothed(recording, generator.uniform(0.0, 0.8))
    position = marked(position + gait(recording, generator), recording, generator)
    velocity = np.diff(position, axis=1, prepend=2 * position[:, :1] - position[:, 1:2])
    velocity /= recording.time_step
    return Recording(
        recording.time_step, position.astype(np.float32), velocity.astype(np.float32),
        recording.goal, recording.radius, recording.obstacles,
    )  # fmt: skip


def smoothed(recording: Recording, window: float) -> np.ndarray:
    """Return positions averaged over a window, s: nobody starts or turns within an instant."""
    reach = round(0.5 * window / recording.time_step)
    before = recording.position[:, :1] - recording.velocity[:, :1] * (
        recording.time_step * np.arange(reach, 0, -1)[:, None, None]
    )
    after = recording.position[:, -1:] + recording.velocity[:, -1:] * (
        recording.time_step * np.arange(1, reach + 1)[:, None, None]
    )
    longer = np.concatenate([before, recording.position, after], axis=1)
    parts = [longer[:, start : start + recording.moments] for start in range(2 * reach + 1)]
    return np.mean(parts, axis=0, dtype=np.float64)


def gait(recording: Recording, generator: np.random.Generator) -> np.ndarray:
    """Return how walking bodies sway, speed up and wander, m, as positions are."""
    shape = (recording.worlds, 1, recording.people)
    time = recording.time_step * np.arange(recording.moments)[None, :, None]

    def wave(low: float, high: float, frequency: np.ndarray) -> np.ndarray:
        amplitude = generator.uniform(low, high, shape) / (2.0 * np.pi * frequency)
        return amplitude * np.sin(
            2.0 * np.pi * (frequency * time + generator.uniform(0.0, 1.0, shape))
        )

    steps = generator.uniform(0.7, 1.1, shape)
    across, along = wave(0.0, 0.2, steps), wave(0.0, 0.15, 2.0 * steps)
    for _ in range(WANDERINGS):
        across += wave(0.0, 0.08, generator.uniform(0.08, 0.5, shape))
        along += wave(0.0, 0.06, generator.uniform(0.08, 0.5, shape))
    speed = np.linalg.norm(recording.velocity, axis=-1)
    walking = np.clip(speed / 0.5, 0.2, 1.0).mean(axis=1, keepdims=True)
    heading = recording.velocity.mean(axis=1, keepdims=True) + 1e-3
    heading = heading / np.linalg.norm(heading, axis=-1, keepdims=True)
    left = np.stack([-heading[..., 1], heading[..., 0]], axis=-1)
    return (walking * along)[..., None] * heading + (walking * across)[..., None] * left


def marked(
    position: np.ndarray, recording: Recording, generator: np.random.Generator
) -> np.ndarray:
    """Return positions that somebody marked now and then, with errors, straight between, m."""
    duration = recording.time_step * (recording.moments - 1)
    count = int(duration / generator.uniform(*SPACING)) + 2
    exact = np.linspace(0.0, recording.moments - 1.0, count)
    marks = between(position, exact)
    marks += generator.uniform(0.0, LARGEST_ERROR) * generator.standard_normal(marks.shape)
    return between(marks, np.linspace(0.0, count - 1.0, recording.moments))


def between(values: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Return values, (worlds, moments, ...), at places between their moments."""
    first = np.minimum(places.astype(int), values.shape[1] - 2)
    share = (places - first)[:, None, None]
    return (1.0 - share) * values[:, first] + share * values[:, first + 1]
