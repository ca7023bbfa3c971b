"""
People who push each other away, and walk where they look.

Source: F. Farina, D. Fontanelli, A. Garulli, A. Giannitrapani and D. Prattichizzo, Walking ahead:
the headed social force model, PLoS ONE 12(1), 2017.
"""

import math
from typing import NamedTuple

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.forces import (
    limited,
    limited_accelerations,
    seen_agents,
    social_accelerations,
)
from socialnav_core.simulation.crowds.goals import renew_goals, velocities_to_goals
from socialnav_core.simulation.crowds.social_force import Force
from socialnav_core.simulation.crowds.social_force_kernel import HASTE, SUBSTEP
from socialnav_core.simulation.kinematics.angles import direction

PUSH = Force(strength=5.0, reach=0.15)
"""Who hardly moves sideways is pushed harder than in social_force, and from less far."""
MASS = 70.0
"""Of a person, kg; the constants below are the paper's."""
SIDEWAYS, DAMPING = 1.0, 500.0 / MASS
"""Share of the forces that moves people sideways, and how that motion dies away, 1/s."""
ALPHA, TURNING = 3.0, 0.3 * MASS
"""Ratio of the two poles of turning; its stiffness for a wish of 1 m/s^2, 1/s^2."""


class Walk(NamedTuple):
    """People in motion."""

    position: np.ndarray
    """m, (batch, people, 2)."""
    motion: np.ndarray
    """m/s, (batch, people, 2)."""
    heading: np.ndarray
    """rad, (batch, people)."""
    turn_rate: np.ndarray
    """rad/s, (batch, people)."""


def make_crowd(scenario: Scenario, batch_size: int) -> 'HeadedCrowd':
    """Return the crowd."""
    return HeadedCrowd(batch_size, scenario.pedestrians)


class HeadedCrowd:
    """Remembers where people look and how fast they turn."""

    def __init__(self, batch_size: int, people: int) -> None:
        """Make room; `reset` fills it."""
        self._heading = np.zeros((batch_size, people))
        self._turn_rate = np.zeros((batch_size, people))

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Let the people of some worlds look at their goals."""
        people = self._heading.shape[1]
        way = episodes.goal[worlds, :people] - episodes.state.agents.position[worlds, :people]
        self._heading[worlds] = np.arctan2(way[..., 1], way[..., 0])
        self._turn_rate[worlds] = 0.0

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write the mean velocities of the coming step; see Crowd.decide."""
        people, agents = self._heading.shape[1], episodes.state.agents
        preferred = velocities_to_goals(episodes, people)[due]
        others = seen_agents(episodes.state.select(due), episodes.scenario)
        walk = Walk(
            agents.position[due, :people], agents.velocity[due, :people], self._heading[due],
            self._turn_rate[due],
        )  # fmt: skip
        fastest = HASTE * episodes.preferred_speed[due, :people]
        duration = episodes.scenario.time_step
        substeps = max(1, math.ceil(duration / SUBSTEP - 1e-9))
        for _ in range(substeps):
            radius = others.radius[:, :people]
            pushed = social_accelerations(walk.position, others, radius, preferred, PUSH)
            walk = moved(walk, preferred, pushed, fastest, duration / substeps)
        velocities[due, :people] = (walk.position - agents.position[due, :people]) / duration
        self._heading[due], self._turn_rate[due] = walk.heading, walk.turn_rate

    def renew_goals(self, episodes: Episodes) -> None:
        """Give another goal to whoever has arrived; see Crowd.renew_goals."""
        renew_goals(episodes)

    def get_state(self) -> dict[str, np.ndarray]:
        """Return where people look and how fast they turn."""
        return {'heading': self._heading.copy(), 'turn_rate': self._turn_rate.copy()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from there."""
        self._heading, self._turn_rate = arrays['heading'].copy(), arrays['turn_rate'].copy()


def moved(
    walk: Walk, preferred: np.ndarray, pushed: np.ndarray, fastest: np.ndarray, duration: float
) -> Walk:
    """
    Return people a moment later.

    :param preferred: m/s, (batch, people, 2).
    :param pushed: acceleration by others, m/s^2, (batch, people, 2).
    :param fastest: m/s, (batch, people).
    :param duration: s.
    """
    wish = (preferred - walk.motion) / Force().relaxation
    pushed = limited_accelerations(pushed)
    ahead = direction(walk.heading)
    left = np.stack([-ahead[..., 1], ahead[..., 0]], axis=-1)
    forwards = (walk.motion * ahead).sum(-1) + duration * ((wish + pushed) * ahead).sum(-1)
    sideways = (walk.motion * left).sum(-1) * (1.0 - DAMPING * duration)
    sideways += duration * SIDEWAYS * (pushed * left).sum(-1)
    strength = TURNING * np.linalg.norm(wish, axis=-1)
    error = walk.heading - np.arctan2(wish[..., 1], wish[..., 0])
    error = np.arctan2(np.sin(error), np.cos(error))
    damping = (1.0 + ALPHA) * np.sqrt(strength / ALPHA)  # implicit, since it can be stiff
    turn_rate = (walk.turn_rate - duration * strength * error) / (1.0 + duration * damping)
    heading = walk.heading + duration * turn_rate
    ahead = direction(heading)
    left = np.stack([-ahead[..., 1], ahead[..., 0]], axis=-1)
    motion = limited(forwards[..., None] * ahead + sideways[..., None] * left, fastest)
    return Walk(walk.position + duration * motion, motion, heading, turn_rate)
