"""What is decided, and what a decision was about."""

import dataclasses

import numpy as np

from socialnav.control.reasons import Cause
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.states import CrowdState

NO_COMMAND = np.zeros(2)


@dataclasses.dataclass(frozen=True)
class Decision:
    """What the robot shall do now."""

    command: np.ndarray
    """(vx, vy) in base_link, m/s, or speed and turn rate of a differential drive, (2,)."""
    reason: str | None = None
    """Why the robot stands; None while it drives."""
    publish: bool = True
    """False once the robot has stood for so long that others may command it."""
    stamp: int = 0
    """Time of the state that is answered in lockstep, ns."""
    concern: str | None = None
    """What is wrong though it drives."""
    turn_rate: float = 0.0
    """How fast a holonomic base turns besides, rad/s."""
    cause: Cause | None = None
    """Of what kind the reason is; None while it drives."""


@dataclasses.dataclass(frozen=True)
class Intention:
    """What the latest decision was about."""

    state: CrowdState
    """The world when the command takes effect, batch of one."""
    command: np.ndarray
    """(vx, vy) in the world frame, m/s, or speed and turn rate, (2,)."""
    plan: np.ndarray | None = None
    """Where the policy means to be afterwards, m, (steps, 2), if it tells."""


def speed_of(decision: Decision, kinematics: str) -> float:
    """Return how fast a decision moves the robot, m/s."""
    return float(np.hypot(*kinematics_of(kinematics).twist(decision.command)[:2]))
