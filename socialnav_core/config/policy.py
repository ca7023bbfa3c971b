"""Settings of a value network and of the way it chooses an action."""

import dataclasses
import math
from typing import Annotated

from socialnav_core.config.mapping import require
from socialnav_core.config.ranges import OneOf, Range, require_allowed
from socialnav_core.config.scenario import KINEMATICS, RewardConfig

NETWORKS = ('sarl', 'gat4sn', 'gat4sn_linear', 'gat4sn_v2')
MOST_ACTIONS = 5000


@dataclasses.dataclass(frozen=True)
class ScreeningConfig:
    """Masking of actions after which no action of the set stays free of collisions."""

    enabled: bool = False
    """Whether actions are screened."""
    horizon: Annotated[float, Range(0, 30)] = 1.5
    """How long the escape must stay free, s."""
    margin: Annotated[float, Range(0, 5)] = 0.02
    """Clearance to keep from obstacles, m."""
    moving_margin: Annotated[float, Range(0, 5)] = 0.1
    """Clearance to keep from walking pedestrians, m."""
    standing_margin: Annotated[float, Range(0, 5)] = 0.25
    """Clearance to keep from standing pedestrians, m."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)


@dataclasses.dataclass(frozen=True)
class PolicyConfig:
    """A value network and the way it chooses an action."""

    network: Annotated[str, OneOf(NETWORKS)] = 'sarl'
    """Value network: sarl, gat4sn, gat4sn_linear (no LeakyReLU in its attention) or gat4sn_v2."""
    heads: Annotated[int, Range(1, 64)] = 4
    """Attention heads of the gat4sn networks."""
    speeds: Annotated[int, Range(1, 50)] = 2
    """Number of speeds of the action set, spaced exponentially up to the preferred speed."""
    headings: Annotated[int, Range(1, 360)] = 8
    """Number of headings (holonomic) or turn rates (differential) of the action set."""
    max_turn_rate: Annotated[float, Range(0.01, 20)] = math.pi
    """Largest turn rate of the action set of a differential drive, rad/s."""
    kinematics: Annotated[str, OneOf(KINEMATICS)] = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    lookahead: str = 'constant_velocity'
    """Prediction of the pedestrians: a name in prediction.PREDICTIONS."""
    time_step: Annotated[float, Range(0.01, 2)] = 0.25
    """Time that an action lasts, s."""
    goal_tolerance: Annotated[float, Range(0.001, 5)] = 0.3
    """Distance at which the goal counts as reached, m."""
    reward: RewardConfig = RewardConfig()
    """Reward that the network was trained on."""
    screening: ScreeningConfig = ScreeningConfig()
    """Screening of actions by safety."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        require_allowed(self)
        require(
            self.speeds * self.headings <= MOST_ACTIONS,
            f'policy: speeds times headings must be at most {MOST_ACTIONS}',
        )

    @property
    def actions(self) -> int:
        """Return the number of actions that a decision weighs, the stop among them."""
        return self.speeds * self.headings + 1
