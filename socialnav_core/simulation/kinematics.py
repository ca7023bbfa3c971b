"""How the robot moves, and the commands that it chooses from."""

import math

import numpy as np

from socialnav_core.config import PolicyConfig


def move_robot(
    kinematics: str, heading: np.ndarray, command: np.ndarray, duration: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """
    Return what a command does: displacement (..., 2), velocity (..., 2) and heading (...).

    A holonomic robot keeps its heading. A differential drive follows an exact arc; its velocity is
    that at the end of it.

    :param kinematics: holonomic or differential.
    :param heading: rad, (...).
    :param command: (vx, vy) in the world frame or (speed, turn rate), (..., 2).
    :param duration: s.
    """
    if kinematics == 'holonomic':
        return command * duration, command, heading
    speed, turn_rate = command[..., 0], command[..., 1]
    half_turn = 0.5 * turn_rate * duration
    chord = speed * duration * np.sinc(half_turn / math.pi)  # sinc is exact for a straight line
    displacement = chord[..., None] * direction(heading + half_turn)
    end_heading = heading + turn_rate * duration
    return displacement, speed[..., None] * direction(end_heading), wrap(end_heading)


def action_set(config: PolicyConfig) -> np.ndarray:
    """
    Return the candidate commands of a robot whose preferred speed is 1 m/s, (actions, 2).

    The stop comes first. Speeds are spaced exponentially, (exp(i / n) - 1) / (e - 1); headings are
    spread over the circle of the world frame, turn rates evenly over their range.

    :param config: number of speeds and headings, kinematics.
    """
    ramp = np.arange(1, config.speeds + 1) / config.speeds
    speeds = np.expm1(ramp) / math.expm1(1.0)
    stop = np.zeros((1, 2))
    if config.kinematics == 'holonomic':
        angles = np.linspace(0.0, 2.0 * math.pi, config.headings, endpoint=False)
        moves = speeds[:, None, None] * direction(angles)
        return np.concatenate([stop, moves.reshape(-1, 2)])
    rates = np.linspace(-config.max_turn_rate, config.max_turn_rate, config.headings)
    grid = np.stack(np.broadcast_arrays(np.r_[0.0, speeds][:, None], rates), axis=-1)
    return np.concatenate([stop, grid.reshape(-1, 2)])


def scale_actions(kinematics: str, actions: np.ndarray, preferred_speed: np.ndarray) -> np.ndarray:
    """
    Return the candidate commands of each robot, (batch, actions, 2).

    :param kinematics: holonomic or differential; turn rates are not scaled.
    :param actions: of `action_set`, (actions, 2).
    :param preferred_speed: m/s, (batch,).
    """
    scaled = actions * preferred_speed[:, None, None]
    if kinematics == 'differential':
        scaled[..., 1] = actions[:, 1]
    return scaled


def direction(angle: np.ndarray) -> np.ndarray:
    """
    Return unit vectors, (..., 2).

    :param angle: rad, (...).
    """
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def wrap(angle: np.ndarray) -> np.ndarray:
    """
    Return angles in [-pi, pi).

    :param angle: rad.
    """
    return (angle + math.pi) % (2.0 * math.pi) - math.pi
