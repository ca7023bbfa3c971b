"""Forces between people, as in `social_force_kernel`, for crowds that add others to them."""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import Scenario
from socialnav_core.simulation.crowds.social_force import Force
from socialnav_core.simulation.crowds.social_force_kernel import CONTACT, GREATEST_ACCELERATION
from socialnav_core.states import Agents, CrowdState

FARTHEST = 25.0
"""Who is farther away than this many reaches pushes by less than the rounding of a number."""


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
    force, out = force or Force(), np.zeros_like(position)
    push_people(
        position, others.position, radius, others.radius, others.valid, preferred, *force, out
    )
    return out


@compiled
def push_people(  # type: ignore[no-untyped-def]
    position, there, radius, radii, valid, preferred, strength, reach, relaxation, behind, out
):
    """
    Add the accelerations of people, m/s^2, (batch, people, 2); see `social_accelerations`.

    :param there: of everybody, those of the people are old, m, (batch, agents, 2).
    :param radii: of everybody, m, (batch, agents).
    """
    people = position.shape[1]
    for world in range(position.shape[0]):
        for i in range(people):
            ahead_x, ahead_y = preferred[world, i, 0], preferred[world, i, 1]
            speed = math.sqrt(ahead_x * ahead_x + ahead_y * ahead_y)
            for j in range(there.shape[1]):
                if i == j or not valid[world, j]:
                    continue
                place = position[world, j] if j < people else there[world, j]
                x, y = position[world, i, 0] - place[0], position[world, i, 1] - place[1]
                distance = math.sqrt(x * x + y * y)
                gap = distance - radius[world, i] - radii[world, j]
                if distance == 0.0 or gap > FARTHEST * reach:
                    continue
                push = strength * math.exp(-max(gap, 0.0) / reach)
                if speed > 0.0:
                    ahead = -(x * ahead_x + y * ahead_y) / (speed * distance)
                    push *= behind + (1.0 - behind) * 0.5 * (1.0 + ahead)
                push += CONTACT * max(-gap, 0.0)
                out[world, i, 0] += push * x / distance
                out[world, i, 1] += push * y / distance


def limited(vectors: np.ndarray, greatest: float | np.ndarray) -> np.ndarray:
    """Return vectors, (..., 2), shortened where they are longer than this."""
    length = np.linalg.norm(vectors, axis=-1)
    return vectors * np.minimum(1.0, greatest / np.maximum(length, 1e-12))[..., None]


def limited_accelerations(vectors: np.ndarray) -> np.ndarray:
    """Return accelerations, (..., 2), that people can have, m/s^2."""
    return limited(vectors, GREATEST_ACCELERATION)
