"""What every policy is."""

from typing import Any, Protocol

import numpy as np

from socialnav_core.config import ConfigError, Scenario
from socialnav_core.states import CrowdState


class Policy(Protocol):
    """Chooses a command for the robot of each world."""

    kinematics: str
    """holonomic: commands are (vx, vy) in the world frame; differential: (speed, turn rate)."""

    def act(self, state: CrowdState) -> np.ndarray:
        """
        Return the commands, float64 (batch, 2).

        :param state: the worlds as they are.
        """
        ...

    def reset(self) -> None:
        """Forget what was seen; a new episode begins."""
        ...


def require_same_kinematics(policy: Any, scenario: Scenario) -> None:
    """
    Raise a ConfigError when a policy cannot drive the robot of a scenario.

    :param policy: a Policy.
    :param scenario: the world.
    """
    if policy.kinematics != scenario.kinematics:
        raise ConfigError(
            f'the policy drives a {policy.kinematics} robot and scenario {scenario.name} has a '
            f'{scenario.kinematics} one; set scenario.kinematics={policy.kinematics}'
        )


def attach_oracle(policy: Any, oracle: Any) -> None:
    """
    Hand the pedestrians' next velocities to a policy that looks ahead with the oracle.

    :param policy: a Policy.
    :param oracle: returns the velocities for the states that the policy is asked about next.
    """
    if getattr(getattr(policy, 'config', None), 'lookahead', None) == 'oracle':
        policy.oracle = oracle
