"""A limit of speed that others set while a robot drives."""

import dataclasses
import math

from socialnav.parameters.policy import PolicyParameters

SLOWEST = 1e-3
"""A limit is not lower, m/s, so that a policy never divides by a speed of nothing."""


@dataclasses.dataclass(frozen=True)
class SpeedLimit:
    """A largest speed."""

    value: float = 0.0
    """m/s, or a percentage; 0 for no limit."""
    percentage: bool = False
    """Whether the value is a percentage of max_speed."""


NO_LIMIT = SpeedLimit()


def complaint(limit: SpeedLimit) -> str | None:
    """Return what is wrong with a limit, or None."""
    if math.isfinite(limit.value) and limit.value >= 0:
        return None
    return f'ignored: speed_limit: {limit.value:g} is no speed'


def limited(settings: PolicyParameters, limit: SpeedLimit) -> PolicyParameters:
    """Return settings with max_speed and preferred_speed within a limit."""
    if limit.value == 0:
        return settings
    share = settings.max_speed * limit.value / 100
    largest = max(share if limit.percentage else limit.value, SLOWEST)
    return dataclasses.replace(
        settings,
        max_speed=min(settings.max_speed, largest),
        preferred_speed=min(settings.preferred_speed, largest),
    )
