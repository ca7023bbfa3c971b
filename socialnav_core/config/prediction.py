"""Settings of the learned prediction: the crowds it learns from, and its training."""

import dataclasses
from typing import Annotated

from socialnav_core.config.mapping import require
from socialnav_core.config.ranges import NAME, Range, require_allowed
from socialnav_core.config.training import LARGEST_SEED

SHARES = ('scenarios', 'varied', 'stop_and_go', 'unaware', 'social_force', 'street')
"""Kinds of crowds; each is a field of CrowdMixture."""


@dataclasses.dataclass(frozen=True)
class CrowdMixture:
    """How often each kind of crowd is drawn, in parts of their sum."""

    scenarios: Annotated[float, Range(0, 1000)] = 0.35
    """The named scenarios with the project's own ORCA."""
    varied: Annotated[float, Range(0, 1000)] = 0.15
    """ORCA with other horizons, distances, speeds, radii, numbers and time steps."""
    stop_and_go: Annotated[float, Range(0, 1000)] = 0.1
    """The same with people who stop at once and start again."""
    unaware: Annotated[float, Range(0, 1000)] = 0.05
    """The same with people who avoid nobody."""
    social_force: Annotated[float, Range(0, 1000)] = 0.1
    """People who push each other away (Helbing and Molnar 1995)."""
    street: Annotated[float, Range(0, 1000)] = 0.25
    """People who walk on, alone or side by side, stand about or set off, seen as by a tracker."""

    def __post_init__(self) -> None:
        """Refuse shares that are none."""
        require_allowed(self)
        require(any(getattr(self, name) for name in SHARES), 'crowds.mixture: all shares are 0')


@dataclasses.dataclass(frozen=True)
class CrowdsConfig:
    """The recorded crowds that the network learns from."""

    groups: Annotated[int, Range(1, 100_000)] = 360
    """Recordings; each draws its own kind, numbers, parameters and time step."""
    validation_groups: Annotated[int, Range(1, 100_000)] = 40
    """Recordings of the validation split, on which the weights are chosen."""
    worlds: Annotated[int, Range(1, 4096)] = 12
    """Worlds of a recording, which share its parameters."""
    duration: Annotated[float, Range(5, 600)] = 20.0
    """Length of a recording, s."""
    mixture: CrowdMixture = CrowdMixture()
    """Kinds of crowds."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class NoiseConfig:
    """What is done to the recordings so that the network trusts its inputs no more than it may."""

    share: Annotated[float, Range(0, 1)] = 0.4
    """Share of the batches with measurement noise."""
    position: Annotated[float, Range(0, 5)] = 0.05
    """Standard deviation of positions, m; a batch has U(0, 1.2) times of both."""
    velocity: Annotated[float, Range(0, 5)] = 0.1
    """Standard deviation of velocities, m/s."""
    forgetting: Annotated[float, Range(0, 1)] = 0.1
    """Share of the people whose history is cut after a random number of samples."""
    beginning: Annotated[float, Range(0, 1)] = 0.1
    """Share of the examples from the first 1.5 s of an episode."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class PredictionTrainingConfig:
    """Regression on what people did next."""

    updates: Annotated[int, Range(1, 100_000_000)] = 12000
    """Gradient steps."""
    recordings_per_update: Annotated[int, Range(1, 1000)] = 4
    """Recordings that a batch draws from."""
    moments_per_recording: Annotated[int, Range(1, 10_000)] = 14
    """Moments, in random worlds, drawn from each; every person then is an example."""
    width: Annotated[int, Range(1, 2048)] = 192
    """Units of each of the three hidden layers."""
    learning_rate: Annotated[float, Range(1e-9, 1)] = 2e-3
    """Learning rate after the warm-up; it falls to nearly zero along a cosine."""
    weight_decay: Annotated[float, Range(0, 1)] = 1e-4
    """Of AdamW."""
    gradient_clip: Annotated[float, Range(1e-6, 1e6)] = 5.0
    """Largest norm of the gradient."""
    distance_weight: Annotated[float, Range(0, 1000)] = 1.0
    """Weight of the plain distance beside the likelihood."""
    degrees_of_freedom: Annotated[float, Range(1, 1000)] = 4.0
    """Of Student's t, by which the means learn: the fewer, the less outliers count."""
    goal_weight: Annotated[float, Range(0, 1000)] = 0.1
    """Weight of the auxiliary output, the direction to the person's goal."""
    validation_updates: Annotated[int, Range(1, 100_000_000)] = 1000
    """Updates between two looks at the validation crowds; the state is saved then."""
    noise: NoiseConfig = NoiseConfig()
    """Noise and forgetting."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class PredictionConfig:
    """A training run of the learned prediction."""

    name: Annotated[str, NAME]
    """Name of the run."""
    seed: Annotated[int, Range(0, LARGEST_SEED)] = 0
    """Seed of crowds, weights and batches."""
    crowds: CrowdsConfig = CrowdsConfig()
    """What it learns from."""
    training: PredictionTrainingConfig = PredictionTrainingConfig()
    """How."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)
