"""Settings of a value network and of the way it chooses an action."""

import dataclasses
import math

from socialnav_core.config.mapping import require, require_choice
from socialnav_core.config.scenario import KINEMATICS, RewardConfig

NETWORKS = ('sarl', 'gat4sn', 'gat4sn_linear', 'gat4sn_v2')


@dataclasses.dataclass(frozen=True)
class ScreeningConfig:
    """Masking of actions after which no action of the set stays free of collisions."""

    enabled: bool = False
    """Whether actions are screened."""
    horizon: float = 1.5
    """How long the escape must stay free, s."""
    margin: float = 0.02
    """Clearance to keep from obstacles, m."""
    moving_margin: float = 0.1
    """Clearance to keep from walking pedestrians, m."""
    standing_margin: float = 0.25
    """Clearance to keep from standing pedestrians, m."""


@dataclasses.dataclass(frozen=True)
class PolicyConfig:
    """A value network and the way it chooses an action."""

    network: str = 'sarl'
    """Value network: sarl, gat4sn, gat4sn_linear (no LeakyReLU in its attention) or gat4sn_v2."""
    heads: int = 4
    """Attention heads of the gat4sn networks."""
    speeds: int = 2
    """Number of speeds of the action set, spaced exponentially up to the preferred speed."""
    headings: int = 8
    """Number of headings (holonomic) or turn rates (differential) of the action set."""
    max_turn_rate: float = math.pi
    """Largest turn rate of the action set of a differential drive, rad/s."""
    kinematics: str = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    lookahead: str = 'constant_velocity'
    """Prediction of the pedestrians: a name in prediction.PREDICTIONS."""
    time_step: float = 0.25
    """Time that an action lasts, s."""
    goal_tolerance: float = 0.3
    """Distance at which the goal counts as reached, m."""
    reward: RewardConfig = RewardConfig()
    """Reward that the network was trained on."""
    screening: ScreeningConfig = ScreeningConfig()
    """Screening of actions by safety."""

    def __post_init__(self) -> None:
        """Refuse values that describe no policy."""
        require_choice('policy.network', self.network, NETWORKS)
        require_choice('kinematics', self.kinematics, KINEMATICS)
        require(self.heads >= 1, 'policy.heads must be at least 1')
        require(self.speeds >= 1 and self.headings >= 1, 'policy: the action set is empty')
