"""What every policy is."""

from collections.abc import Mapping
import dataclasses
from typing import Protocol

import numpy as np

from socialnav_core.config import ConfigError, Scenario
from socialnav_core.prediction import Predictor
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


@dataclasses.dataclass(frozen=True)
class PolicyDescription:
    """What results tell of a policy."""

    name: str
    """Kind of the policy: that of its network, or orca, straight_line ..."""
    kinematics: str
    """holonomic: commands are (vx, vy) in the world frame; differential: (speed, turn rate)."""
    prediction: str | None = None
    """Name of its prediction of the pedestrians; None where it has none."""
    knowledge: str | None = None
    """What that may know; see `Predictor`."""
    screening: bool = False
    """Whether its actions are screened."""
    remembers: bool = False
    """Whether decisions depend on earlier ones: row i of all states is then the same world."""
    settings: Mapping[str, float] = dataclasses.field(default_factory=dict)
    """Other settings that a result is to tell, by name."""

    @property
    def look_ahead(self) -> str | None:
        """Return its prediction and what that knows, as texts tell them; None without one."""
        return f'{self.prediction} ({self.knowledge})' if self.prediction else None


class Policy(Protocol):
    """Chooses a command for the robot of each world."""

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of it."""
        ...

    @property
    def predictor(self) -> Predictor | None:
        """Return what it predicts people by; None for a policy without a prediction."""
        ...

    @property
    def plan(self) -> np.ndarray | None:
        """Return where the latest decision leads, for eyes, m, (batch, steps, 2), if it tells."""
        ...

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the commands, float64 (batch, 2).

        :param limits: what the robot can do until its next command, None: anything. A policy may
            leave them aside: whoever passes them on cuts its commands to them.
        :raises ValueError: for a state in which a number is not finite; see `require_finite`.
        """
        ...

    def attention(self, state: CrowdState) -> np.ndarray | None:
        """Return how much it looks at each agent, summing to 1, (batch, agents), if it tells."""
        ...

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """
        Forget what was seen of worlds that begin a new episode.

        :param worlds: indices or a mask; None for all.
        """
        ...


def require_same_kinematics(policy: Policy, scenario: Scenario) -> None:
    """Raise a ConfigError when a policy cannot drive the robot of a scenario."""
    kinematics = policy.description.kinematics
    if kinematics != scenario.kinematics:
        raise ConfigError(
            f'the policy drives a {kinematics} robot and scenario {scenario.name} has a '
            f'{scenario.kinematics} one; set scenario.kinematics={kinematics}'
        )
