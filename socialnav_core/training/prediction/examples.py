"""Examples of what people did next, drawn from recordings."""

import dataclasses

import numpy as np

from socialnav_core.config.prediction import NoiseConfig
from socialnav_core.prediction.learned.features import person_features
from socialnav_core.prediction.learned.history import lagged_motions, SAMPLES
from socialnav_core.prediction.learned.layout import LAG, LAGS, MOTION, TIMES
from socialnav_core.training.prediction.recording import Recording

GREATEST_NOISE = 1.2  # in units of the standard deviations of NoiseConfig
BEGINNING = LAG * LAGS  # s


@dataclasses.dataclass
class Examples:
    """People, each in their own frame, float32, and how their motion differed from constant."""

    features: np.ndarray
    """What the network sees, (people, INPUTS)."""
    residual: np.ndarray
    """True positions less those of constant velocity, m, (people, STEPS, 2)."""
    goal: np.ndarray
    """Direction to the goal, (people, 2)."""


def draw_examples(
    recordings: list[Recording], moments: int, noise: NoiseConfig, generator: np.random.Generator
) -> Examples:
    """Return everybody at some random moments of each recording."""
    level = generator.uniform(0.0, GREATEST_NOISE) * float(generator.random() < noise.share)
    parts = [
        recording_examples(recording, moments, level, noise, generator) for recording in recordings
    ]
    names = [field.name for field in dataclasses.fields(Examples)]
    return Examples(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def recording_examples(
    recording: Recording,
    count: int,
    level: float,
    noise: NoiseConfig,
    generator: np.random.Generator,
) -> Examples:
    """Return everybody at some random moments of a recording, seen with a level of noise."""
    world, moment = draw_moments(recording, count, noise.beginning, generator)
    times, motions, seen = seen_samples(recording, world, moment, noise.forgetting, generator)
    if level:
        scale = level * np.repeat([noise.velocity, noise.position], 2)
        motions += scale * generator.standard_normal(motions.shape)
    position = motions[:, 0, :, 2:]
    truth = recording.future(world, moment, TIMES) - position[:, None]
    goal = recording.goal[world, moment] - position
    lagged, known = lagged_motions(times, motions, seen)
    features, frames = everybody(recording, world, position, lagged, known)
    constant = lagged[:, 0, :, None, :2] * TIMES[:, None]
    residual = truth.transpose(0, 2, 1, 3) - constant
    people = residual.shape[0] * residual.shape[1]
    return Examples(
        features,
        turned(residual.reshape(people, len(TIMES), 2), frames).astype(np.float32),
        turned(unit(goal).reshape(people, 1, 2), frames)[:, 0].astype(np.float32),
    )


def draw_moments(
    recording: Recording, count: int, beginning: float, generator: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Return worlds and moments; a share of the latter lies at the beginning, (count,) each."""
    last = recording.moments - 1 - int(np.ceil(TIMES[-1] / recording.time_step))
    early = max(1, round(BEGINNING / recording.time_step))
    moment = np.where(
        generator.random(count) < beginning,
        generator.integers(0, early, count),
        generator.integers(0, last + 1, count),
    )
    return generator.integers(0, recording.worlds, count), moment


def seen_samples(
    recording: Recording,
    world: np.ndarray,
    moment: np.ndarray,
    forgetting: float,
    generator: np.random.Generator,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """
    Return times, motions and whether people were seen, newest first, as a History has them.

    :param forgetting: share of the people whose older samples are missing.
    """
    back = moment[:, None] - np.arange(SAMPLES)
    times = np.where(back >= 0, back * recording.time_step, -np.inf)
    index = world[:, None], np.maximum(back, 0)
    motions = np.concatenate(
        [recording.velocity[index], recording.position[index]], axis=-1, dtype=np.float64
    )
    shape = (len(world), recording.people)
    kept = np.where(
        generator.random(shape) < forgetting, generator.integers(1, SAMPLES, shape), SAMPLES
    )
    seen = (np.arange(SAMPLES)[:, None] < kept[:, None]) & (back >= 0)[:, :, None]
    return times, motions, seen


def everybody(
    recording: Recording,
    world: np.ndarray,
    position: np.ndarray,
    lagged: np.ndarray,
    known: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Return features and frames of all people among people and obstacles."""
    centres = np.concatenate([position, recording.obstacles[world]], axis=1)
    walls = recording.obstacles.shape[1]
    lagged = np.concatenate([lagged, np.zeros((*lagged.shape[:2], walls, MOTION))], axis=2)
    known = np.concatenate([known, np.zeros((*known.shape[:2], walls), bool)], axis=2)
    static = np.tile(np.arange(centres.shape[1]) >= recording.people, (len(world), 1))
    _, features, frames = person_features(
        centres, lagged, known, recording.radius[world], static, np.ones_like(static)
    )
    return features, frames


def turned(vectors: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """Return vectors, (people, n, 2), in the frames of their people, (people, 2)."""
    cosine, sine = frames[:, None, 0], frames[:, None, 1]
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack([x * cosine + y * sine, y * cosine - x * sine], axis=-1)


def unit(vectors: np.ndarray) -> np.ndarray:
    """Return vectors of length one, or shorter where they are next to nothing."""
    return vectors / (np.linalg.norm(vectors, axis=-1, keepdims=True) + 1e-6)
