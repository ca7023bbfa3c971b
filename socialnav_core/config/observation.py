"""Settings of what a policy sees of a simulated world."""

import dataclasses
import math
from typing import Annotated

from socialnav_core.config.ranges import Range, require_allowed


@dataclasses.dataclass(frozen=True)
class ObservationConfig:
    """How people are seen; the robot and obstacles are known as they are."""

    position_noise: Annotated[float, Range(0, 100)] = 0.0
    """Standard deviation of positions along each axis, m."""
    velocity_noise: Annotated[float, Range(0, 100)] = 0.0
    """Standard deviation of velocities along each axis, m/s."""
    missed: Annotated[float, Range(0, 0.99)] = 0.0
    """Share of the people who are not seen, drawn anew in every step."""
    reach: Annotated[float, Range(0.01, 10_000, or_infinite=True)] = math.inf
    """Gap to the robot beyond which people are not seen, m."""
    delay: Annotated[float, Range(0, 2)] = 0.0
    """Age of what is seen, s, at most a time step."""

    def __post_init__(self) -> None:
        """Refuse values that describe no sensor."""
        require_allowed(self)
