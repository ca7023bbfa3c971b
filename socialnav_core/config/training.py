"""Settings of training, and of a run as a whole."""

import dataclasses

from socialnav_core.config.mapping import require, require_choice
from socialnav_core.config.policy import PolicyConfig
from socialnav_core.config.scenario import Scenario

DEVICES = ('cpu', 'cuda')
OPTIMIZERS = ('adam', 'sgd')
SCHEDULERS = ('smooth', 'baby_step', 'one_pass')
POSITIVE_TRAINING_FIELDS = (
    'worlds', 'iterations', 'steps_per_iteration', 'batch_size', 'replay_capacity',
    'learning_rate', 'final_learning_rate', 'gradient_clip', 'checkpoint_iterations',
)  # fmt: skip
COUNTS = ('episodes', 'updates_per_iteration', 'updates_per_episode', 'target_update_episodes')


@dataclasses.dataclass(frozen=True)
class ImitationConfig:
    """Regression of the value network on the returns of an ORCA robot."""

    episodes: int = 1500
    """Number of demonstrations."""
    safety_space: float = 0.15
    """Added to every radius by the demonstrator, m."""
    stale_radii: bool = False
    """Whether the demonstrator believes the first case's radii in all, a defect of the report."""
    epochs: int = 3
    """Passes over the demonstrations."""
    batch_size: int = 256
    """States per update."""
    learning_rate: float = 1e-3
    """Learning rate at the start."""
    final_learning_rate: float = 1e-4
    """Learning rate at the end, reached exponentially."""


@dataclasses.dataclass(frozen=True)
class CurriculumConfig:
    """Obstacles that grow with success."""

    enabled: bool = False
    """Whether the curriculum is used; otherwise the scenario stays as it is."""
    scheduler: str = 'smooth'
    """Radii of a level: smooth, baby_step or one_pass (docs/training.md)."""
    start_radius: float = 0.3
    """Largest obstacle radius of the first level, m."""
    radius_step: float = 0.2
    """Added at each level, m."""
    final_radius: float = 2.5
    """Largest obstacle radius of the last level, m."""
    target_success: float = 0.7
    """Success rate over the window that opens the next level."""
    window: int = 50
    """Number of the latest episodes begun at a level that are counted."""
    largest_minimum: float = 0.5
    """Most that baby_step and one_pass raise the smallest radius to, m; more finds no room."""

    def __post_init__(self) -> None:
        """Refuse a scheduler that does not exist."""
        require_choice('training.curriculum.scheduler', self.scheduler, SCHEDULERS)


@dataclasses.dataclass(frozen=True)
class TrainingConfig:
    """Value learning after imitation."""

    worlds: int = 128
    """Worlds simulated side by side."""
    iterations: int = 100
    """Rounds of collection and updates; length of a run where `episodes` is 0."""
    episodes: int = 0
    """Length of a run in episodes that ended, imitation not counted; 0: `iterations` counts."""
    steps_per_iteration: int = 16
    """Steps of each world in one iteration."""
    updates_per_iteration: int = 24
    """Gradient updates in one iteration, where `updates_per_episode` is 0."""
    updates_per_episode: int = 0
    """Gradient updates for each episode that ended in an iteration; 0: a fixed number."""
    batch_size: int = 512
    """States per update."""
    replay_capacity: int = 60000
    """States kept for replay; half of it holds demonstrations at the start."""
    store_timeouts: bool = True
    """Whether states of episodes that ran out of time are replayed."""
    optimizer: str = 'adam'
    """Optimizer of imitation and of value learning: adam or sgd."""
    momentum: float = 0.9
    """Momentum of sgd."""
    learning_rate: float = 1e-3
    """Learning rate at the start."""
    final_learning_rate: float = 1e-4
    """Learning rate at the end."""
    decay_start: float = 0.3
    """Share of the run after which the learning rate falls exponentially."""
    gradient_clip: float = 1.0
    """Largest norm of the gradient; .inf for any."""
    trace_decay: float = 0.7
    """Lambda of Watkins' Q(lambda) targets."""
    target_update_episodes: int = 0
    """Episodes after which the network of one-step targets is renewed; 0: Q(lambda) targets."""
    epsilon_start: float = 0.3
    """Share of random actions at the start."""
    epsilon_end: float = 0.05
    """Share of random actions from epsilon_share on."""
    epsilon_share: float = 0.5
    """Share of the run over which epsilon falls linearly."""
    lookahead: str = 'oracle'
    """Prediction of the pedestrians while training: a name in prediction.PREDICTIONS."""
    device: str = 'cpu'
    """Where the network is computed: cpu or cuda; another device gives other weights."""
    bfloat16: bool = True
    """Whether products are in bfloat16 where the processor has it; weights stay float32."""
    fold_constant_features: bool = True
    """Whether the saved network ignores features that never varied in training."""
    checkpoint_iterations: int = 10
    """Iterations between two saved states."""
    imitation: ImitationConfig = ImitationConfig()
    """What comes first."""
    curriculum: CurriculumConfig = CurriculumConfig()
    """Growth of the obstacles."""

    def __post_init__(self) -> None:
        """Refuse values with which nothing can be learned."""
        require_choice('training.device', self.device, DEVICES)
        for name in POSITIVE_TRAINING_FIELDS:
            require(getattr(self, name) > 0, f'training.{name} must be positive')
        for name in COUNTS:
            require(getattr(self, name) >= 0, f'training.{name} must not be negative')
        require_choice('training.optimizer', self.optimizer, OPTIMIZERS)
        require(0 <= self.momentum < 1, 'training.momentum must lie in [0, 1)')
        require(0 <= self.trace_decay <= 1, 'training.trace_decay must lie in [0, 1]')
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

    name: str
    """Name of the run and of its folder."""
    scenario: Scenario
    """World that is trained in."""
    policy: PolicyConfig = PolicyConfig()
    """Network and action set."""
    training: TrainingConfig = TrainingConfig()
    """How it learns."""
    seed: int = 0
    """Seed of the weights, cases and exploration."""
