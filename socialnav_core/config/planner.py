"""Settings of a planner: the search, the value network at its horizon, and how that is trained."""

import dataclasses

from socialnav_core.config.mapping import require, require_choice
from socialnav_core.config.policy import NETWORKS
from socialnav_core.config.search import SearchConfig


@dataclasses.dataclass(frozen=True)
class PlannerTrainingConfig:
    """Value learning under the search: it drives, what followed is learned, it drives by that."""

    rounds: int = 4
    """Times that it drives and learns."""
    groups: int = 64
    """Worlds that are drawn anew in each round."""
    episodes: int = 24
    """Episodes in each of them."""
    validation_groups: int = 24
    """Worlds of the validation split that each round is measured in, without exploration."""
    named_share: float = 0.5
    """Share of the worlds that are named scenarios; the others are drawn at random."""
    exploration: float = 0.15
    """Standard deviation of a random preference for some direction at the horizon, s/m."""
    stride: int = 2
    """One of so many steps of an episode becomes an example."""
    intrusion: float = 1.0
    """Cost of a second nearer to somebody than the comfort distance of the search, s."""
    collision: float = 8.0
    """Cost of a collision, s."""
    largest_cost: float = 10.0
    """Costs beyond the way to the goal are cut to this, s."""
    updates: int = 2500
    """Gradient steps of each round."""
    batch_size: int = 256
    """Examples of a gradient step."""
    learning_rate: float = 1e-3
    """Learning rate at the beginning of a round; it falls to nearly zero along a cosine."""
    weight_decay: float = 1e-4
    """Of AdamW."""
    gradient_clip: float = 5.0
    """Largest norm of the gradient."""

    def __post_init__(self) -> None:
        """Refuse numbers that train nothing."""
        for name in ('rounds', 'groups', 'episodes', 'validation_groups', 'stride', 'updates',
                     'batch_size', 'learning_rate', 'gradient_clip', 'largest_cost'):  # fmt: skip
            require(getattr(self, name) > 0, f'training.{name} must be positive')
        for name in ('exploration', 'intrusion', 'collision', 'weight_decay'):
            require(getattr(self, name) >= 0, f'training.{name} must not be negative')
        require(0 <= self.named_share <= 1, 'training.named_share must lie in [0, 1]')


@dataclasses.dataclass(frozen=True)
class PlannerConfig:
    """A search with a value network at its horizon."""

    name: str
    """Name of the run."""
    seed: int = 0
    """Seed of worlds, weights, exploration and batches."""
    network: str = 'sarl'
    """Value network: sarl, gat4sn, gat4sn_linear or gat4sn_v2."""
    heads: int = 4
    """Attention heads of the gat4sn networks."""
    policy: SearchConfig = SearchConfig()
    """The search."""
    training: PlannerTrainingConfig = PlannerTrainingConfig()
    """How the network is trained."""

    def __post_init__(self) -> None:
        """Refuse a network that does not exist."""
        require_choice('network', self.network, NETWORKS)
        require(self.heads >= 1, 'heads must be at least 1')
