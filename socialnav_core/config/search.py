"""Settings of the search in space and time."""

import dataclasses

from socialnav_core.config.differential import DifferentialConfig
from socialnav_core.config.mapping import require, require_choice
from socialnav_core.config.scenario import KINEMATICS

POSITIVE = (
    'horizon', 'time_step', 'layer', 'cell', 'fine_cell', 'slack', 'goal_tolerance', 'grid',
    'window', 'deviation_limit',
)  # fmt: skip
NOT_NEGATIVE = (
    'fine_layers', 'contact', 'intrusion', 'comfort_distance', 'turning', 'obstacle_margin',
    'deviation_floor', 'deviation_share',
)  # fmt: skip
SHARES = ('contact_discount', 'intrusion_discount')


@dataclasses.dataclass(frozen=True)
class SearchConfig:
    """What the search looks at, and what it is worth; costs are in seconds of travel."""

    kinematics: str = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    lookahead: str = 'constant_velocity'
    """Prediction of the pedestrians, by its name."""
    horizon: float = 3.0
    """How far ahead the search looks, s."""
    time_step: float = 0.25
    """How long a command lasts, s: the duration of the first layer."""
    layer: float = 0.25
    """Least duration of the later layers, s; a longer time step takes its place."""
    headings: int = 16
    """Number of headings of the lattice."""
    speeds: int = 2
    """Number of speeds of the lattice, evenly spaced up to the preferred one."""
    cell: float = 0.25
    """Side of the cells that keep one node each, in seconds at preferred speed."""
    fine_cell: float = 0.125
    """The same for the first layers."""
    fine_layers: int = 6
    """Number of first layers with fine cells."""
    slack: float = 2.0
    """Nodes that are worse than the best of their layer by more than this are dropped, s."""
    contact: float = 3.5
    """Cost of a certain contact at the first layer, s."""
    contact_discount: float = 0.8
    """Factor of that cost for each later layer: what is far ahead will be planned again."""
    intrusion: float = 0.4
    """Cost of each second spent nearer to somebody than the comfort distance."""
    intrusion_discount: float = 0.85
    """Factor of that cost for each later layer."""
    comfort_distance: float = 0.2
    """Gap to people that is comfortable, m."""
    turning: float = 0.1
    """Cost of a change of velocity by the preferred speed, s."""
    obstacle_margin: float = 0.02
    """Gap to obstacles and walls that is kept, m."""
    deviation_share: float = 1.0
    """Factor of the predicted standard deviations."""
    deviation_floor: float = 0.0
    """Added to the predicted standard deviations, m."""
    deviation_limit: float = 0.25
    """Standard deviations count up to this, m: a risk that is everywhere would make it wait."""
    goal_tolerance: float = 0.3
    """The goal counts as reached within this distance, m; where it does not, the robot goes on."""
    grid: float = 0.125
    """Side of the cells of the distances around obstacles, m."""
    window: float = 12.0
    """Half-width of the square around the robot in which these are computed, m."""

    differential: DifferentialConfig = DifferentialConfig()
    """What only a differential drive has."""

    def __post_init__(self) -> None:
        """Refuse values that describe no search."""
        require_choice('kinematics', self.kinematics, KINEMATICS)
        for name in POSITIVE:
            require(getattr(self, name) > 0, f'{name} must be positive')
        for name in NOT_NEGATIVE:
            require(getattr(self, name) >= 0, f'{name} must not be negative')
        for name in SHARES:
            require(0 <= getattr(self, name) <= 1, f'{name} must lie in [0, 1]')
        require(self.headings >= 3 and self.speeds >= 1, 'a lattice needs 3 headings and a speed')
        require(self.horizon >= self.time_step, 'horizon must be at least time_step')
        require(self.window >= 8 * self.grid, 'window must be at least 8 cells of the grid')
