"""Settings of the bound that a clairvoyant search sets."""

import dataclasses

from socialnav_core.config.mapping import require


@dataclasses.dataclass(frozen=True)
class BoundConfig:
    """How finely the clairvoyant search looks, and what it keeps to people."""

    headings: int = 64
    """Number of headings."""
    cell: float = 0.0625
    """Side of the cells that keep one position in each step, m; at most half a step is used."""
    comfort_distance: float = 0.2
    """Gap to people that the comfortable path keeps, m."""

    def __post_init__(self) -> None:
        """Refuse values that describe no search."""
        require(self.headings >= 3, 'bound: headings must be at least 3')
        require(0.001 <= self.cell <= 1.0, 'bound: cell must lie in [0.001, 1] m')
        require(self.comfort_distance >= 0.0, 'bound: comfort_distance must not be negative')
