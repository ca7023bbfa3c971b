"""Settings of training, and of a run as a whole."""

import dataclasses
from typing import Annotated

from socialnav_core.config.mapping import require
from socialnav_core.config.policy import PolicyConfig
from socialnav_core.config.ranges import DIGEST, NAME, OneOf, Range, require_allowed
from socialnav_core.config.scenario import Scenario

DEVICES = ('cpu', 'cuda')
OPTIMIZERS = ('adam', 'sgd')
SCHEDULERS = ('smooth', 'baby_step', 'one_pass')
LARGEST_SEED = 2**63 - 1


@dataclasses.dataclass(frozen=True)
class ImitationConfig:
    """Regression of the value network on the returns of an ORCA robot."""

    episodes: Annotated[int, Range(0, 1_000_000)] = 1500
    """Number of demonstrations."""
    safety_space: Annotated[float, Range(0, 5)] = 0.15
    """Added to every radius by the demonstrator, m."""
    stale_radii: bool = False
    """Whether the demonstrator believes the first case's radii in all, a defect of the report."""
    epochs: Annotated[int, Range(0, 1000)] = 3
    """Passes over the demonstrations."""
    batch_size: Annotated[int, Range(1, 65_536)] = 256
    """States per update."""
    learning_rate: Annotated[float, Range(1e-9, 1)] = 1e-3
    """Learning rate at the start."""
    final_learning_rate: Annotated[float, Range(1e-9, 1)] = 1e-4
    """Learning rate at the end, reached exponentially."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class CurriculumConfig:
    """Obstacles that grow with success."""

    enabled: bool = False
    """Whether the curriculum is used; otherwise the scenario stays as it is."""
    scheduler: Annotated[str, OneOf(SCHEDULERS)] = 'smooth'
    """Radii of a level: smooth, baby_step or one_pass (docs/training.md)."""
    start_radius: Annotated[float, Range(0.01, 100)] = 0.3
    """Largest obstacle radius of the first level, m."""
    radius_step: Annotated[float, Range(0.001, 100)] = 0.2
    """Added at each level, m."""
    final_radius: Annotated[float, Range(0.01, 100)] = 2.5
    """Largest obstacle radius of the last level, m."""
    target_success: Annotated[float, Range(0, 1)] = 0.7
    """Success rate over the window that opens the next level."""
    window: Annotated[int, Range(1, 100_000)] = 50
    """Number of the latest episodes begun at a level that are counted."""
    largest_minimum: Annotated[float, Range(0.01, 100)] = 0.5
    """Most that baby_step and one_pass raise the smallest radius to, m; more finds no room."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class TrainingConfig:
    """Value learning after imitation."""

    worlds: Annotated[int, Range(1, 65_536)] = 128
    """Worlds simulated side by side."""
    kinds: Annotated[int, Range(0, 1024)] = 0
    """
    Kinds of worlds among them, drawn by the seed, with up to the scenario's numbers of pedestrians
    and obstacles (docs/training.md); 0: all are the scenario's.
    """
    iterations: Annotated[int, Range(1, 10_000_000)] = 100
    """Rounds of collection and updates; length of a run where `episodes` is 0."""
    episodes: Annotated[int, Range(0, 100_000_000)] = 0
    """Length of a run in episodes that ended, imitation not counted; 0: `iterations` counts."""
    steps_per_iteration: Annotated[int, Range(1, 10_000)] = 16
    """Steps of each world in one iteration."""
    updates_per_iteration: Annotated[int, Range(0, 100_000)] = 24
    """Gradient updates in one iteration, where `updates_per_episode` is 0."""
    updates_per_episode: Annotated[int, Range(0, 100_000)] = 0
    """Gradient updates for each episode that ended in an iteration; 0: a fixed number."""
    batch_size: Annotated[int, Range(1, 65_536)] = 512
    """States per update."""
    replay_capacity: Annotated[int, Range(1, 100_000_000)] = 60000
    """States kept for replay; half of it holds demonstrations at the start."""
    store_timeouts: bool = True
    """Whether states of episodes that ran out of time are replayed."""
    optimizer: Annotated[str, OneOf(OPTIMIZERS)] = 'adam'
    """Optimizer of imitation and of value learning: adam or sgd."""
    momentum: Annotated[float, Range(0, 0.9999)] = 0.9
    """Momentum of sgd."""
    learning_rate: Annotated[float, Range(1e-9, 1)] = 1e-3
    """Learning rate at the start."""
    final_learning_rate: Annotated[float, Range(1e-9, 1)] = 1e-4
    """Learning rate at the end."""
    decay_start: Annotated[float, Range(0, 1)] = 0.3
    """Share of the run after which the learning rate falls exponentially."""
    gradient_clip: Annotated[float, Range(1e-6, 1e6, or_infinite=True)] = 1.0
    """Largest norm of the gradient; .inf for any."""
    trace_decay: Annotated[float, Range(0, 1)] = 0.7
    """Lambda of Watkins' Q(lambda) targets."""
    target_update_episodes: Annotated[int, Range(0, 100_000_000)] = 0
    """Episodes after which the network of one-step targets is renewed; 0: Q(lambda) targets."""
    epsilon_start: Annotated[float, Range(0, 1)] = 0.3
    """Share of random actions at the start."""
    epsilon_end: Annotated[float, Range(0, 1)] = 0.05
    """Share of random actions from epsilon_share on."""
    epsilon_share: Annotated[float, Range(0, 1)] = 0.5
    """Share of the run over which epsilon falls linearly."""
    lookahead: str = 'oracle'
    """Prediction of the pedestrians while training: a name in prediction.PREDICTIONS."""
    initial_weights: Annotated[str, DIGEST] = ''
    """Digest of the weights that `--init` begins with, in place of imitation; empty for none."""
    device: Annotated[str, OneOf(DEVICES)] = 'cpu'
    """Where the network is computed: cpu or cuda; another device gives other weights."""
    bfloat16: bool = True
    """Whether products are in bfloat16 where the processor has it; weights stay float32."""
    fold_constant_features: bool = True
    """Whether the saved network ignores features that never varied in training."""
    checkpoint_iterations: Annotated[int, Range(1, 10_000_000)] = 10
    """Iterations between two saved states."""
    imitation: ImitationConfig = ImitationConfig()
    """What comes first."""
    curriculum: CurriculumConfig = CurriculumConfig()
    """Growth of the obstacles."""

    def __post_init__(self) -> None:
        """Refuse values with which nothing can be learned."""
        require_allowed(self)
        require(
            not self.kinds or (self.worlds % self.kinds == 0 and not self.curriculum.enabled),
            f'training.worlds ({self.worlds}) must be a multiple of training.kinds '
            f'({self.kinds}), which exclude training.curriculum',
        )
        require(
            not self.target_update_episodes or self.trace_decay == 0,
            'training.target_update_episodes asks for one-step targets, training.trace_decay for '
            'longer ones; set one of them to 0',
        )

    @property
    def length(self) -> int:
        """Return the length of a run: in episodes where that is given, else in iterations."""
        return self.episodes or self.iterations


@dataclasses.dataclass(frozen=True)
class Config:
    """A training run, complete: what `socialnav train` reads and a checkpoint keeps."""

    name: Annotated[str, NAME]
    """Name of the run and of its folder."""
    scenario: Scenario
    """World that is trained in."""
    policy: PolicyConfig = PolicyConfig()
    """Network and action set."""
    training: TrainingConfig = TrainingConfig()
    """How it learns."""
    seed: Annotated[int, Range(0, LARGEST_SEED)] = 0
    """Seed of the weights, cases and exploration."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)
