"""ORCA for people of whom some give way to nobody, with the robot among them where it is seen."""

import numpy as np

from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.orca import RADIUS_PADDING, RECIPROCAL
from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step

ALONE = 1.0
"""Share of a conflict with somebody who does not give way that others take."""


def walk_by_orca(
    episodes: Episodes,
    due: np.ndarray,
    preferred: np.ndarray,
    blind: np.ndarray,
    velocities: np.ndarray,
) -> None:
    """
    Write the velocities of people as Crowd.decide does.

    :param preferred: m/s, (batch, agents, 2).
    :param blind: who avoids nobody, so that others avoid them alone, bool (batch, people).
    """
    scenario, agents = episodes.scenario, episodes.state.agents
    people, orca, robot = scenario.pedestrians, scenario.orca, episodes.state.robot
    speed, out = episodes.preferred_speed, velocities.copy()
    if scenario.robot_visible:  # one more body, behind the others
        agents = agents.append(robot.as_agents())
        speed = np.concatenate([speed, robot.preferred_speed[:, None]], axis=1)
        out = np.concatenate([out, robot.velocity[:, None]], axis=1)
    share = np.where(agents.static, orca.static_responsibility, RECIPROCAL)
    share[:, :people][blind] = ALONE
    distance = np.full_like(agents.radius, orca.neighbor_distance)
    distance[:, :people][blind] = 0.0
    bodies = Bodies(
        position=agents.position,
        velocity=agents.velocity,
        preferred_velocity=preferred,
        radius=agents.radius + (RADIUS_PADDING + orca.safety_space),
        max_speed=speed,
        valid=agents.valid,
        responsibility=share,
        neighbor_distance=distance,
    )
    foresight = Foresight(orca.max_neighbors, orca.time_horizon, scenario.time_step)
    orca_step(bodies, foresight, due, people, out)
    velocities[due, :people] = out[due, :people]
