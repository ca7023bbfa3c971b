"""Settings of the learned prediction: the crowds it learns from, and its training."""

import dataclasses

from socialnav_core.config.mapping import require

SHARES = ('scenarios', 'varied', 'stop_and_go', 'unaware', 'social_force')
"""Kinds of crowds; each is a field of CrowdMixture."""


@dataclasses.dataclass(frozen=True)
class CrowdMixture:
    """How often each kind of crowd is drawn, in parts of their sum."""

    scenarios: float = 0.4
    """The named scenarios with the project's own ORCA."""
    varied: float = 0.2
    """ORCA with other horizons, distances, speeds, radii, numbers and time steps."""
    stop_and_go: float = 0.15
    """The same with people who stop at once and start again."""
    unaware: float = 0.1
    """The same with people who avoid nobody."""
    social_force: float = 0.15
    """People who push each other away (Helbing and Molnar 1995)."""

    def __post_init__(self) -> None:
        """Refuse shares that are none."""
        shares = [getattr(self, name) for name in SHARES]
        require(min(shares) >= 0 and sum(shares) > 0, 'mixture: shares are negative or all zero')


@dataclasses.dataclass(frozen=True)
class CrowdsConfig:
    """The recorded crowds that the network learns from."""

    groups: int = 300
    """Recordings; each draws its own kind, numbers, parameters and time step."""
    validation_groups: int = 24
    """Recordings of the validation split, on which the weights are chosen."""
    worlds: int = 12
    """Worlds of a recording, which share its parameters."""
    duration: float = 20.0
    """Length of a recording, s."""
    mixture: CrowdMixture = CrowdMixture()
    """Kinds of crowds."""

    def __post_init__(self) -> None:
        """Refuse what records nothing."""
        least = min(self.groups, self.validation_groups, self.worlds)
        require(least >= 1, 'crowds: groups, validation_groups and worlds must be at least 1')
        require(self.duration >= 5.0, 'crowds.duration must be at least 5 s')


@dataclasses.dataclass(frozen=True)
class NoiseConfig:
    """What is done to the recordings so that the network trusts its inputs no more than it may."""

    share: float = 0.4
    """Share of the batches with measurement noise."""
    position: float = 0.05
    """Standard deviation of positions, m; a batch has U(0, 1.2) times of both."""
    velocity: float = 0.1
    """Standard deviation of velocities, m/s."""
    forgetting: float = 0.1
    """Share of the people whose history is cut after a random number of samples."""
    beginning: float = 0.1
    """Share of the examples from the first 1.5 s of an episode."""


@dataclasses.dataclass(frozen=True)
class PredictionTrainingConfig:
    """Regression on what people did next."""

    updates: int = 15000
    """Gradient steps."""
    recordings_per_update: int = 4
    """Recordings that a batch draws from."""
    moments_per_recording: int = 14
    """Moments, in random worlds, drawn from each; every person then is an example."""
    width: int = 192
    """Units of each of the three hidden layers."""
    learning_rate: float = 2e-3
    """Learning rate after the warm-up; it falls to nearly zero along a cosine."""
    weight_decay: float = 1e-4
    """Of AdamW."""
    gradient_clip: float = 5.0
    """Largest norm of the gradient."""
    distance_weight: float = 0.5
    """Weight of the plain distance beside the likelihood."""
    goal_weight: float = 0.1
    """Weight of the auxiliary output, the direction to the person's goal."""
    validation_updates: int = 1000
    """Updates between two looks at the validation crowds; the state is saved then."""
    noise: NoiseConfig = NoiseConfig()
    """Noise and forgetting."""

    def __post_init__(self) -> None:
        """Refuse numbers that train nothing."""
        for name in ('updates', 'recordings_per_update', 'moments_per_recording', 'width',
                     'learning_rate', 'gradient_clip', 'validation_updates'):  # fmt: skip
            require(getattr(self, name) > 0, f'training.{name} must be positive')


@dataclasses.dataclass(frozen=True)
class PredictionConfig:
    """A training run of the learned prediction."""

    name: str
    """Name of the run."""
    seed: int = 0
    """Seed of crowds, weights and batches."""
    crowds: CrowdsConfig = CrowdsConfig()
    """What it learns from."""
    training: PredictionTrainingConfig = PredictionTrainingConfig()
    """How."""
