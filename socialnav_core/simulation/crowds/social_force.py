"""People who push each other away by social forces."""

from typing import NamedTuple

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import velocities_to_goals
from socialnav_core.simulation.crowds.memoryless import Memoryless
from socialnav_core.simulation.crowds.social_force_kernel import social_force_step


class Force(NamedTuple):
    """What `social_force_step` takes; a person's usual force by default."""

    strength: float = 2.0
    """Acceleration at contact, m/s^2."""
    reach: float = 0.3
    """Distance over which it falls to 1 / e, m."""
    relaxation: float = 0.5
    """Time in which the preferred velocity is taken up, s."""
    behind: float = 0.3
    """Share of the force of somebody straight behind."""


def make_crowd(scenario: Scenario, batch_size: int) -> Memoryless:
    """Return the crowd: a decision depends on the present state alone."""
    return Memoryless(decide)


def decide(episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
    """Write the velocities to which people are pushed; see Crowd.decide."""
    scenario, agents, speed = episodes.scenario, episodes.state.agents, episodes.preferred_speed
    if scenario.robot_visible:  # one more body, behind the others
        agents = agents.append(episodes.state.robot.as_agents())
    preferred = velocities_to_goals(episodes, agents.count)
    out = np.empty_like(preferred)
    social_force_step(
        agents.position, agents.velocity, preferred, agents.radius, speed, scenario.pedestrians,
        *Force(), scenario.time_step, out,
    )  # fmt: skip
    velocities[due, : scenario.pedestrians] = out[due, : scenario.pedestrians]
