"""Settings of the search that only a differential drive has."""

import dataclasses

from socialnav_core.config.mapping import require

POSITIVE = (
    'acceleration', 'turn_rate', 'angular_acceleration', 'far_layer', 'slack', 'cell', 'far_cell',
)  # fmt: skip
NOT_NEGATIVE = ('near', 'fine_layers', 'sure', 'steering', 'turn_loss', 'reverse')


@dataclasses.dataclass(frozen=True)
class DifferentialConfig:
    """The base where nobody hands its limits over, and the lattice of its speeds and turns."""

    acceleration: float = 1.0
    """Largest change of the speed where no limit is handed over, m/s^2."""
    turn_rate: float = 1.5
    """Largest turn rate where no limit is handed over, rad/s."""
    angular_acceleration: float = 2.0
    """Largest change of the turn rate where no limit is handed over, rad/s^2."""
    reverse: float = 0.0
    """Largest speed backwards, as a share of the preferred one."""
    near: float = 1.0
    """Until then layers last SearchConfig.layer, s."""
    far_layer: float = 0.5
    """Duration of the layers after that, s."""
    fine_layers: int = 2
    """Number of first layers in which changes by half of what is possible are tried too."""
    beam: int = 600
    """The best so many nodes of a layer are followed."""
    slack: float = 4.0
    """Nodes that are worse than the best of their layer by more than this are dropped, s."""
    cell: float = 0.125
    """Side of the cells that keep one node each until `near`, in seconds at preferred speed."""
    far_cell: float = 0.25
    """The same after that."""
    headings: int = 24
    """Number of headings that cells tell apart."""
    speeds: int = 4
    """Number of speeds that cells tell apart, besides the stop."""
    turn_rates: int = 6
    """Number of turn rates that cells tell apart, besides going straight."""
    sure: float = 1.0
    """So far ahead risks count in full, s: a robot that drives cannot stop at once."""
    steering: float = 0.1
    """Cost of a change of the turn rate by the largest one, s."""
    turn_loss: float = 1.0
    """Factor of the time that turning towards the way to the goal is taken to cost."""
    arc_share: float = 0.4
    """Part of that time which a turn on a wide arc saves."""

    def __post_init__(self) -> None:
        """Refuse values that describe no search."""
        for name in POSITIVE:
            require(getattr(self, name) > 0, f'differential.{name} must be positive')
        for name in NOT_NEGATIVE:
            require(getattr(self, name) >= 0, f'differential.{name} must not be negative')
        require(0 <= self.arc_share <= 1, 'differential.arc_share must lie in [0, 1]')
        require(self.reverse <= 1, 'differential.reverse must not be more than 1')
        for name in ('beam', 'speeds', 'turn_rates'):
            require(getattr(self, name) >= 1, f'differential.{name} must be at least 1')
        require(self.headings >= 4, 'differential.headings must be at least 4')
