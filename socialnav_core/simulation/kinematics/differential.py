"""A robot with two driven wheels: it drives where it looks, and turns."""

import math

import numpy as np

from socialnav_core.config import PolicyConfig
from socialnav_core.simulation.kinematics.angles import direction, wrap
from socialnav_core.simulation.kinematics.limits import changed, Limits
from socialnav_core.simulation.kinematics.speeds import exponential_speeds
from socialnav_core.states import Robot


class DifferentialDrive:
    """Follows a speed and a turn rate along an exact arc; `Kinematics` says what is what."""

    has_heading = True
    straight = False
    directions = 'turn rates'

    def action_set(self, config: PolicyConfig) -> np.ndarray:
        """Return the stop, and every speed and turning on the spot with even turn rates."""
        rates = np.linspace(-config.max_turn_rate, config.max_turn_rate, config.headings)
        speeds = np.r_[0.0, exponential_speeds(config.speeds)]
        grid = np.stack(np.broadcast_arrays(speeds[:, None], rates), axis=-1)
        return np.concatenate([np.zeros((1, 2)), grid.reshape(-1, 2)])

    def scale(self, actions: np.ndarray, preferred_speed: np.ndarray) -> np.ndarray:
        """Return the commands at each robot's speed; turn rates stay as they are."""
        scaled = actions * preferred_speed[:, None, None]
        scaled[..., 1] = actions[:, 1]
        return scaled

    def move(
        self, heading: np.ndarray, command: np.ndarray, duration: float
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return displacement, velocity and heading after an arc, by its chord."""
        speed, turn_rate = command[..., 0], command[..., 1]
        half_turn = 0.5 * turn_rate * duration
        chord = speed * duration * np.sinc(half_turn / math.pi)  # exact for a straight line too
        displacement = chord[..., None] * direction(heading + half_turn)
        end_heading = heading + turn_rate * duration
        return displacement, speed[..., None] * direction(end_heading), wrap(end_heading)

    def present_command(self, robot: Robot) -> np.ndarray:
        """Return the speed along the heading, and the turn rate."""
        speed = (robot.velocity * direction(robot.heading)).sum(axis=-1)
        return np.stack([speed, robot.turn_rate], axis=-1)

    def turn_rates(self, command: np.ndarray) -> np.ndarray:
        """Return the second number of each command."""
        return command[..., 1]

    def reachable(
        self, commands: np.ndarray, present: np.ndarray, limits: Limits, duration: float
    ) -> np.ndarray:
        """Return the commands with speed and turn rate, and the changes of both, bounded."""
        bounds = (
            (limits.speed, limits.acceleration),
            (limits.turn_rate, limits.angular_acceleration),
        )
        numbers = [
            changed(present[..., axis], commands[..., axis], largest, change * duration)
            for axis, (largest, change) in enumerate(bounds)
        ]
        return np.stack(np.broadcast_arrays(*numbers), axis=-1)

    def mean_command(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        """Return the mean speed and the last turn rate, which is reached at once."""
        mean = 0.5 * (first + last)
        mean[..., 1] = last[..., 1]
        return mean

    def to_base(self, command: np.ndarray, heading: float) -> np.ndarray:
        """Return the command, which is the base's own already."""
        return command

    def from_base(self, command: np.ndarray, heading: float) -> np.ndarray:
        """Return the command, which is the base's own."""
        return command

    def twist(self, command: np.ndarray) -> tuple[float, float, float]:
        """Return speed and turn rate; such a base never moves sideways."""
        forward, turn_rate = command.tolist()
        return forward, 0.0, turn_rate

    def from_twist(self, forward: float, left: float, turn_rate: float) -> np.ndarray:
        """Return speed and turn rate alone."""
        return np.array([forward, turn_rate])
