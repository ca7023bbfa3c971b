"""Small worlds for the tests of the search, and a robot that drives through them."""

import numpy as np

from socialnav_core.states import Agents, CrowdState, Robot

STEP = 0.25


def discs(*rows, static=False, velocity=None):
    """Return the agents of one world from rows (x, y, radius)."""
    rows = np.array(rows, float).reshape(-1, 3)
    count = len(rows)
    velocities = np.zeros((count, 2)) if velocity is None else np.array(velocity, float)
    masks = np.full((1, count), static), np.ones((1, count), bool)
    return Agents(rows[None, :, :2], velocities.reshape(1, count, 2), rows[None, :, 2], *masks)


def world(agents=None, start=(0.0, 0.0), goal=(5.0, 0.0), speed=1.0, bounds=np.inf, radius=0.3):
    """Return one world with a robot at rest."""
    robot = Robot(
        np.array([start], float), np.zeros((1, 2)), np.zeros(1), np.array([radius]),
        np.array([speed]), np.array([goal], float),
    )  # fmt: skip
    agents = discs() if agents is None else agents
    return CrowdState(robot, agents, np.array([bounds], float), np.zeros(1))


def gaps(state):
    """Return the gaps between the robot and each agent of one world, m."""
    offset = state.agents.position[0] - state.robot.position[0]
    return np.hypot(*offset.T) - state.agents.radius[0] - state.robot.radius[0]


def drive(policy, state, tolerance=0.3, steps=400, step=STEP):
    """Return the states of one world until the robot has arrived, everybody keeping on."""
    states = [state]
    for _ in range(steps):
        command = policy.act(state)
        assert np.hypot(*command[0]) <= state.robot.preferred_speed[0] * (1 + 1e-9)
        state = state.with_robot(
            position=state.robot.position + command * step, velocity=command
        ).with_agents(position=state.agents.position + state.agents.velocity * step)
        states.append(state)
        if distance_to_goal(state) < tolerance:
            break
    return states


def distance_to_goal(state):
    return np.hypot(*(state.robot.goal - state.robot.position)[0])
