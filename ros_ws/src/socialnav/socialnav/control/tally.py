"""What a controller counts."""

import dataclasses


@dataclasses.dataclass
class Tally:
    """Numbers since the controller was made, for diagnostics."""

    decisions: int = 0
    """Decisions of the policy."""
    late: int = 0
    """Those that took longer than a period."""
    clamped: int = 0
    """Those that were beyond what the robot can do."""
    decision_time: float = 0.0
    """Time that the latest one took, s."""
