"""Settings of what a policy sees of a simulated world."""

import dataclasses
import math

from socialnav_core.config.mapping import require


@dataclasses.dataclass(frozen=True)
class ObservationConfig:
    """How people are seen; the robot and obstacles are known as they are."""

    position_noise: float = 0.0
    """Standard deviation of positions along each axis, m."""
    velocity_noise: float = 0.0
    """Standard deviation of velocities along each axis, m/s."""
    missed: float = 0.0
    """Share of the people who are not seen, drawn anew in every step."""
    reach: float = math.inf
    """Gap to the robot beyond which people are not seen, m."""
    delay: float = 0.0
    """Age of what is seen, s, at most a time step."""

    def __post_init__(self) -> None:
        """Refuse values that describe no sensor."""
        for name in ('position_noise', 'velocity_noise', 'delay'):
            value = getattr(self, name)
            require(0.0 <= value < math.inf, f'observation.{name} must be at least 0')
        require(0.0 <= self.missed < 1.0, 'observation.missed must lie in [0, 1)')
        require(self.reach > 0.0, 'observation.reach must be positive')
