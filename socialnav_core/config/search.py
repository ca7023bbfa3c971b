"""Settings of the search in space and time."""

import dataclasses
from typing import Annotated

from socialnav_core.config.differential import DifferentialConfig
from socialnav_core.config.mapping import require
from socialnav_core.config.ranges import OneOf, Range, require_allowed
from socialnav_core.config.scenario import KINEMATICS

MOST_NODES = 2e6
"""Layers times cells, which decide how much memory the search has."""


@dataclasses.dataclass(frozen=True)
class SearchConfig:
    """What the search looks at, and what it is worth; costs are in seconds of travel."""

    kinematics: Annotated[str, OneOf(KINEMATICS)] = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    lookahead: str = 'constant_velocity'
    """Prediction of the pedestrians, by its name."""
    horizon: Annotated[float, Range(0.01, 30)] = 3.0
    """How far ahead the search looks, s."""
    time_step: Annotated[float, Range(0.01, 2)] = 0.25
    """How long a command lasts, s: the duration of the first layer."""
    layer: Annotated[float, Range(0.01, 5)] = 0.25
    """Least duration of the later layers, s; a longer time step takes its place."""
    headings: Annotated[int, Range(3, 360)] = 16
    """Number of headings of the lattice."""
    speeds: Annotated[int, Range(1, 20)] = 2
    """Number of speeds of the lattice, evenly spaced up to the preferred one."""
    cell: Annotated[float, Range(0.01, 5)] = 0.25
    """Side of the cells that keep one node each, in seconds at preferred speed."""
    fine_cell: Annotated[float, Range(0.01, 5)] = 0.125
    """The same for the first layers."""
    fine_layers: Annotated[int, Range(0, 100)] = 6
    """Number of first layers with fine cells."""
    slack: Annotated[float, Range(0.01, 100)] = 2.0
    """Nodes that are worse than the best of their layer by more than this are dropped, s."""
    contact: Annotated[float, Range(0, 1000)] = 3.5
    """Cost of a certain contact at the first layer, s."""
    contact_discount: Annotated[float, Range(0, 1)] = 0.8
    """Factor of that cost for each later layer: what is far ahead will be planned again."""
    intrusion: Annotated[float, Range(0, 1000)] = 0.4
    """Cost of each second spent nearer to somebody than the comfort distance."""
    intrusion_discount: Annotated[float, Range(0, 1)] = 0.85
    """Factor of that cost for each later layer."""
    comfort_distance: Annotated[float, Range(0, 10)] = 0.2
    """Gap to people that is comfortable, m."""
    turning: Annotated[float, Range(0, 100)] = 0.1
    """Cost of a change of velocity by the preferred speed, s."""
    obstacle_margin: Annotated[float, Range(0, 5)] = 0.02
    """Gap to obstacles and walls that is kept, m."""
    deviation_near: Annotated[float, Range(0, 100)] = 1.0
    """Factor of the predicted standard deviations in the first layer."""
    deviation_share: Annotated[float, Range(0, 100)] = 1.0
    """The factor that this turns into with each later layer: what is far is planned again."""
    deviation_decay: Annotated[float, Range(0, 1)] = 0.8
    """Part of the difference between the two that is left with each later layer."""
    deviation_floor: Annotated[float, Range(0, 10)] = 0.0
    """Added to the predicted standard deviations, m."""
    deviation_limit: Annotated[float, Range(0.001, 10)] = 0.25
    """Standard deviations count up to this, m: a risk that is everywhere would make it wait."""
    goal_tolerance: Annotated[float, Range(0.001, 5)] = 0.3
    """The goal counts as reached within this distance, m; where it does not, the robot goes on."""
    grid: Annotated[float, Range(0.01, 5)] = 0.125
    """Side of the cells of the distances around obstacles, m."""
    window: Annotated[float, Range(0.1, 100)] = 12.0
    """Half-width of the square around the robot in which these are computed, m."""
    crowding: Annotated[float, Range(0, 100)] = 3.0
    """How many metres a metre through somebody who stands counts besides; 0: as any other."""
    usual_speed: Annotated[float, Range(0.01, 10)] = 1.0
    """Preferred speed below which a robot counts people as more, since it needs longer, m/s."""
    value_weight: Annotated[float, Range(0, 100)] = 1.0
    """Factor of the value at the horizon, where there is a network; 0 leaves it aside."""
    candidates: Annotated[int, Range(1, 1000)] = 16
    """First motions whose best paths are valued, at most."""
    candidate_slack: Annotated[float, Range(0, 100)] = 1.0
    """Paths that are worse than the best by more than this are not valued, s."""
    differential: DifferentialConfig = DifferentialConfig()
    """What only a differential drive has."""

    def __post_init__(self) -> None:
        """Refuse values that describe no search."""
        require_allowed(self)
        require(self.horizon >= self.time_step, 'horizon must be at least time_step')
        cells = self.window / self.grid
        require(8 <= cells <= 250, 'window must be 8 to 250 cells of the grid')
        layers = self.horizon / max(self.layer, self.time_step)
        width = 2.0 * self.horizon / min(self.cell, self.fine_cell)
        require(
            layers * width**2 <= MOST_NODES,
            'horizon is too long for so short a layer and so small a cell: raise layer or cell',
        )
