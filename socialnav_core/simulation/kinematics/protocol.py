"""What every kind of base is."""

from typing import Protocol

import numpy as np

from socialnav_core.config import PolicyConfig
from socialnav_core.simulation.kinematics.limits import Limits
from socialnav_core.states import Robot


class Kinematics(Protocol):
    """
    How commands move a robot, (..., 2) each.

    A command is (vx, vy) in the world frame of a holonomic robot, (speed, turn rate) of a
    differential drive. A base, and a Twist, takes (vx, vy) in its own frame instead of the former.
    """

    @property
    def has_heading(self) -> bool:
        """Return whether it matters where the robot looks, so that networks see it."""
        ...

    @property
    def straight(self) -> bool:
        """Return whether a robot that keeps to a command goes straight."""
        ...

    @property
    def directions(self) -> str:
        """Return what the action set spreads besides speeds, in words."""
        ...

    def action_set(self, config: PolicyConfig) -> np.ndarray:
        """
        Return the candidate commands of a robot whose preferred speed is 1 m/s, (actions, 2).

        The stop comes first; speeds are those of `exponential_speeds`.
        """
        ...

    def scale(self, actions: np.ndarray, preferred_speed: np.ndarray) -> np.ndarray:
        """
        Return the candidate commands of each robot, (batch, actions, 2).

        :param actions: of `action_set`, (actions, 2).
        :param preferred_speed: m/s, (batch,).
        """
        ...

    def move(
        self, heading: np.ndarray, command: np.ndarray, duration: float
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """
        Return what a command does: displacement (..., 2), velocity at its end (..., 2), heading.

        :param heading: at the beginning, rad, (...).
        """
        ...

    def present_command(self, robot: Robot) -> np.ndarray:
        """Return the command that a robot seems to follow, (batch, 2)."""
        ...

    def turn_rates(self, command: np.ndarray) -> np.ndarray:
        """Return how fast commands turn a robot, rad/s, (...)."""
        ...

    def reachable(
        self, commands: np.ndarray, present: np.ndarray, limits: Limits, duration: float
    ) -> np.ndarray:
        """
        Return the nearest commands within the limits; those within them come back unchanged.

        :param present: the command followed now.
        :param limits: of the robot; its speed counts more than its acceleration.
        :param duration: time for the change, s.
        """
        ...

    def mean_command(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        """Return the command that moves as far as an even change from one to another."""
        ...

    def to_base(self, command: np.ndarray, heading: float) -> np.ndarray:
        """Return a command, (2,), as the base takes it."""
        ...

    def from_base(self, command: np.ndarray, heading: float) -> np.ndarray:
        """Return what `to_base` made a base's command of, (2,)."""
        ...

    def twist(self, command: np.ndarray) -> tuple[float, float, float]:
        """Return a base's command, (2,), as forward and left speed, m/s, and turn rate, rad/s."""
        ...

    def from_twist(self, forward: float, left: float, turn_rate: float) -> np.ndarray:
        """Return the base's command in a twist, (2,); what the base cannot do is left aside."""
        ...
