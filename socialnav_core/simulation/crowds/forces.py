"""Forces between people, as in `social_force_kernel`, for crowds that add others to them."""

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.crowds.social_force import Force
from socialnav_core.simulation.crowds.social_force_kernel import CONTACT, GREATEST_ACCELERATION
from socialnav_core.states import Agents, CrowdState


def seen_agents(state: CrowdState, scenario: Scenario) -> Agents:
    """Return whom people see: everybody, and behind them the robot where it is visible."""
    if scenario.robot_visible:
        return state.agents.append(state.robot.as_agents())
    return state.agents


def social_accelerations(
    position: np.ndarray,
    others: Agents,
    radius: np.ndarray,
    preferred: np.ndarray,
    force: Force | None = None,
) -> np.ndarray:
    """
    Return how people push each other away, m/s^2, (batch, people, 2).

    :param position: of the people, who are the first of the others, m, (batch, people, 2).
    :param others: everybody; where the people are by now is taken from `position`.
    :param radius: of the people, m, (batch, people).
    :param preferred: m/s, (batch, people, 2).
    """
    force, people = force or Force(), position.shape[1]
    there = others.position.copy()
    there[:, :people] = position
    offset = position[:, :, None] - there[:, None]  # (batch, people, agents, 2)
    distance = np.linalg.norm(offset, axis=-1)
    away = offset / np.where(distance > 0.0, distance, 1.0)[..., None]
    gap = distance - radius[:, :, None] - others.radius[:, None]
    speed = np.linalg.norm(preferred, axis=-1)[..., None]
    heading = preferred / np.where(speed > 0.0, speed, 1.0)
    ahead = -(away * heading[:, :, None]).sum(axis=-1)
    share = force.behind + (1.0 - force.behind) * 0.5 * (1.0 + ahead)
    push = force.strength * np.exp(-np.maximum(gap, 0.0) / force.reach)
    push *= np.where(speed > 0.0, share, 1.0)
    push += CONTACT * np.maximum(-gap, 0.0)
    push *= others.valid[:, None]  # who is at the same place as oneself pushes nowhere
    return (push[..., None] * away).sum(axis=2)


def limited(vectors: np.ndarray, greatest: float | np.ndarray) -> np.ndarray:
    """Return vectors, (..., 2), shortened where they are longer than this."""
    length = np.linalg.norm(vectors, axis=-1)
    return vectors * np.minimum(1.0, greatest / np.maximum(length, 1e-12))[..., None]


def limited_accelerations(vectors: np.ndarray) -> np.ndarray:
    """Return accelerations, (..., 2), that people can have, m/s^2."""
    return limited(vectors, GREATEST_ACCELERATION)
