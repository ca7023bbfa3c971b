"""Settings of the search that only a differential drive has."""

import dataclasses
from typing import Annotated

from socialnav_core.config.ranges import Range, require_allowed


@dataclasses.dataclass(frozen=True)
class DifferentialConfig:
    """The base where nobody hands its limits over, and the lattice of its speeds and turns."""

    acceleration: Annotated[float, Range(0.001, 1000)] = 1.0
    """Largest change of the speed where no limit is handed over, m/s^2."""
    turn_rate: Annotated[float, Range(0.001, 1000)] = 1.5
    """Largest turn rate where no limit is handed over, rad/s."""
    angular_acceleration: Annotated[float, Range(0.001, 1000)] = 2.0
    """Largest change of the turn rate where no limit is handed over, rad/s^2."""
    reverse: Annotated[float, Range(0, 1)] = 0.0
    """Largest speed backwards, as a share of the preferred one."""
    near: Annotated[float, Range(0, 30)] = 1.0
    """Until then layers last SearchConfig.layer, s."""
    far_layer: Annotated[float, Range(0.01, 5)] = 0.5
    """Duration of the layers after that, s."""
    fine_layers: Annotated[int, Range(0, 100)] = 2
    """Number of first layers in which changes by half of what is possible are tried too."""
    beam: Annotated[int, Range(1, 100_000)] = 600
    """The best so many nodes of a layer are followed."""
    slack: Annotated[float, Range(0.01, 100)] = 4.0
    """Nodes that are worse than the best of their layer by more than this are dropped, s."""
    cell: Annotated[float, Range(0.01, 5)] = 0.125
    """Side of the cells that keep one node each until `near`, in seconds at preferred speed."""
    far_cell: Annotated[float, Range(0.01, 5)] = 0.25
    """The same after that."""
    headings: Annotated[int, Range(4, 360)] = 24
    """Number of headings that cells tell apart."""
    speeds: Annotated[int, Range(1, 100)] = 4
    """Number of speeds that cells tell apart, besides the stop."""
    turn_rates: Annotated[int, Range(1, 100)] = 6
    """Number of turn rates that cells tell apart, besides going straight."""
    sure: Annotated[float, Range(0, 30)] = 1.0
    """So far ahead risks count in full, s: a robot that drives cannot stop at once."""
    surprises: Annotated[float, Range(0, 100)] = 0.1
    """How often somebody is taken to walk off in any direction, 1/s."""
    surprise_speed: Annotated[float, Range(0.001, 10)] = 1.0
    """How fast they would walk, m/s."""
    steering: Annotated[float, Range(0, 100)] = 0.1
    """Cost of a change of the turn rate by the largest one, s."""
    turn_loss: Annotated[float, Range(0, 100)] = 1.0
    """Factor of the time that turning towards the way to the goal is taken to cost."""
    arc_share: Annotated[float, Range(0, 1)] = 0.4
    """Part of that time which a turn on a wide arc saves."""

    def __post_init__(self) -> None:
        """Refuse values that describe no search."""
        require_allowed(self)
