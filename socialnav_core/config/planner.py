"""Settings of a planner: the search, the value network at its horizon, and how that is trained."""

import dataclasses
from typing import Annotated

from socialnav_core.config.policy import NETWORKS
from socialnav_core.config.ranges import NAME, OneOf, Range, require_allowed
from socialnav_core.config.search import SearchConfig
from socialnav_core.config.training import LARGEST_SEED


@dataclasses.dataclass(frozen=True)
class PlannerTrainingConfig:
    """Value learning under the search: it drives, what followed is learned, it drives by that."""

    rounds: Annotated[int, Range(1, 1000)] = 3
    """Times that it drives and learns."""
    groups: Annotated[int, Range(1, 100_000)] = 56
    """Worlds that are drawn anew in each round."""
    episodes: Annotated[int, Range(1, 4096)] = 24
    """Episodes in each of them."""
    validation_groups: Annotated[int, Range(1, 100_000)] = 20
    """Worlds of the validation split that each round is measured in, without exploration."""
    named_share: Annotated[float, Range(0, 1)] = 0.6
    """Share of the worlds that are named scenarios; the others are drawn at random."""
    exploration: Annotated[float, Range(0, 100)] = 0.15
    """Standard deviation of a random preference for some direction at the horizon, s/m."""
    stride: Annotated[int, Range(1, 1000)] = 2
    """One of so many steps of an episode becomes an example."""
    intrusion: Annotated[float, Range(0, 1000)] = 1.0
    """Cost of a second nearer to somebody than the comfort distance of the search, s."""
    collision: Annotated[float, Range(0, 1000)] = 8.0
    """Cost of a collision besides the rest of the way, s."""
    largest_cost: Annotated[float, Range(0.01, 1000)] = 10.0
    """Costs beyond the way to the goal are cut to this, s."""
    updates: Annotated[int, Range(1, 10_000_000)] = 2500
    """Gradient steps of each round."""
    batch_size: Annotated[int, Range(1, 65_536)] = 256
    """Examples of a gradient step."""
    learning_rate: Annotated[float, Range(1e-8, 1)] = 1e-3
    """Learning rate at the beginning of a round; it falls to nearly zero along a cosine."""
    weight_decay: Annotated[float, Range(0, 1)] = 1e-4
    """Of AdamW."""
    gradient_clip: Annotated[float, Range(1e-6, 1e6)] = 5.0
    """Largest norm of the gradient."""

    def __post_init__(self) -> None:
        """Refuse numbers that train nothing."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class PlannerConfig:
    """A search with a value network at its horizon."""

    name: Annotated[str, NAME]
    """Name of the run."""
    seed: Annotated[int, Range(0, LARGEST_SEED)] = 0
    """Seed of worlds, weights, exploration and batches."""
    network: Annotated[str, OneOf(NETWORKS)] = 'sarl'
    """Value network: sarl, gat4sn, gat4sn_linear or gat4sn_v2."""
    heads: Annotated[int, Range(1, 64)] = 4
    """Attention heads of the gat4sn networks."""
    policy: SearchConfig = SearchConfig()
    """The search."""
    training: PlannerTrainingConfig = PlannerTrainingConfig()
    """How the network is trained."""

    def __post_init__(self) -> None:
        """Refuse a network that does not exist."""
        require_allowed(self)
