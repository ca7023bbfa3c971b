"""Settings of the bound that a clairvoyant search sets."""

import dataclasses
from typing import Annotated

from socialnav_core.config.ranges import Range, require_allowed


@dataclasses.dataclass(frozen=True)
class BoundConfig:
    """How finely the clairvoyant search looks, and what it keeps to people."""

    headings: Annotated[int, Range(3, 360)] = 64
    """Number of headings."""
    cell: Annotated[float, Range(0.001, 1)] = 0.0625
    """Side of the cells that keep one position in each step, m; at most half a step is used."""
    comfort_distance: Annotated[float, Range(0, 10)] = 0.2
    """Gap to people that the comfortable path keeps, m."""

    def __post_init__(self) -> None:
        """Refuse values that describe no search."""
        require_allowed(self)
