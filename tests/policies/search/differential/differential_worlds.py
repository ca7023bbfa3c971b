"""A differential drive that goes through the small worlds of the search's tests."""

import dataclasses

import numpy as np

from socialnav_core.simulation.kinematics import DifferentialDrive, Limits
from tests.policies.search.search_worlds import distance_to_goal, STEP, world

DRIVE = DifferentialDrive()
LIMITS = Limits(1.0, 1.0, 1.5, STEP, 2.0)


def facing(heading=0.0, speed=0.0, turn_rate=0.0, **settings):
    """Return one world whose robot looks along a heading, and perhaps drives."""
    state = world(**settings)
    velocity = speed * np.array([[np.cos(heading), np.sin(heading)]])
    return state.with_robot(
        heading=np.array([heading]), velocity=velocity, turn_rate=np.array([turn_rate])
    )


def drive(policy, state, limits=LIMITS, tolerance=0.3, steps=200):
    """Return the states and commands until the robot has arrived, everybody keeping on."""
    states, commands = [state], []
    for _ in range(steps):
        command = policy.act(state, limits)
        present = DRIVE.present_command(state.robot)
        reachable = DRIVE.reachable(command, present, limits, limits.period)
        np.testing.assert_allclose(command, reachable, atol=1e-9)
        state = moved(state, command, limits.period)
        states.append(state)
        commands.append(command[0])
        if distance_to_goal(state) < tolerance:
            break
    return states, np.array(commands)


def moved(state, command, duration):
    """Return the state after a command, everybody keeping on."""
    displacement, velocity, heading = DRIVE.move(state.robot.heading, command, duration)
    state = state.with_robot(
        position=state.robot.position + displacement,
        velocity=velocity,
        heading=heading,
        turn_rate=command[:, 1],
    ).with_agents(position=state.agents.position + state.agents.velocity * duration)
    return dataclasses.replace(state, time=state.time + duration)
