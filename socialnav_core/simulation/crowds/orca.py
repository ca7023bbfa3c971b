"""People who avoid each other by ORCA, and whom else they see."""

import numpy as np

from socialnav_core.config import OrcaConfig, Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import velocities_to_goals
from socialnav_core.simulation.crowds.memoryless import Memoryless
from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step
from socialnav_core.states import Agents

RADIUS_PADDING = 0.01  # RVO2's users inflate every disc by it, lest touching ones collide
RECIPROCAL = 0.5


def make_crowd(scenario: Scenario, batch_size: int) -> Memoryless:
    """Return the crowd: a decision depends on the present state alone."""
    return Memoryless(decide)


def decide(episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
    """Write the velocities that avoid everybody who is seen; see Crowd.decide."""
    scenario, agents, speed = episodes.scenario, episodes.state.agents, episodes.preferred_speed
    out = velocities
    if scenario.robot_visible:  # the robot is one more body, behind the others
        robot = episodes.state.robot
        agents = agents.append(robot.as_agents())
        speed = np.concatenate([speed, robot.preferred_speed[:, None]], axis=1)
        out = np.concatenate([velocities, robot.velocity[:, None]], axis=1)
    preferred = velocities_to_goals(episodes, agents.count)
    avoid(
        agents, preferred, speed, scenario.orca, scenario.time_step, due, scenario.pedestrians, out
    )
    if scenario.robot_visible:
        velocities[:] = out[:, : scenario.agents]


def avoid(
    agents: Agents,
    preferred_velocity: np.ndarray,
    speed: np.ndarray,
    settings: OrcaConfig,
    time_step: float,
    worlds: np.ndarray,
    movers: int,
    out: np.ndarray,
) -> None:
    """
    Write the ORCA velocities of the first agents of some worlds, as settings ask for.

    :param preferred_velocity: m/s, (batch, at least movers, 2).
    :param speed: preferred and greatest, m/s, (batch, at least movers).
    :param worlds: bool (batch,); the others keep what is in `out`.
    :param movers: number of agents that decide.
    :param out: m/s, (batch, at least movers, 2), an array of its own.
    """
    bodies = Bodies(
        position=agents.position,
        velocity=agents.velocity,
        preferred_velocity=preferred_velocity,
        radius=agents.radius + (RADIUS_PADDING + settings.safety_space),
        max_speed=speed,
        valid=agents.valid,
        responsibility=np.where(agents.static, settings.static_responsibility, RECIPROCAL),
        neighbor_distance=np.full_like(agents.radius, settings.neighbor_distance),
    )
    foresight = Foresight(settings.max_neighbors, settings.time_horizon, time_step)
    orca_step(bodies, foresight, worlds, movers, out)
