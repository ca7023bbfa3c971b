"""Laws of the robot-centred features."""

import math

import numpy as np
import pytest

from socialnav_core.policies import observe
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.simulation.kinematics import kinematics_of


def scene():
    simulator = Simulator(make_scenario('hard'), 16)
    state = simulator.reset(seed=2)
    return simulator.step(np.tile([0.5, 0.2], (16, 1)))[0], state


def turned(state, angle, shift):
    """Return the worlds turned and shifted as a whole."""
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    return state.with_robot(
        position=state.robot.position @ turn + shift,
        velocity=state.robot.velocity @ turn,
        heading=state.robot.heading + angle,
        goal=state.robot.goal @ turn + shift,
    ).with_agents(
        position=state.agents.position @ turn + shift,
        velocity=state.agents.velocity @ turn,
    )


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
def test_turning_and_shifting_the_world_changes_nothing(kinematics):
    state, _ = scene()
    before = observe(state, kinematics_of(kinematics))
    after = observe(turned(state, 0.7, np.array([3.0, -1.0])), kinematics_of(kinematics))
    assert np.allclose(before.robot, after.robot, atol=1e-5)
    assert np.allclose(before.others, after.others, atol=1e-5)


def test_features_are_those_of_the_definition():
    state, _ = scene()
    seen = observe(state)
    ahead = state.robot.goal[3] - state.robot.position[3]
    axis = ahead / np.linalg.norm(ahead)
    side = np.array([-axis[1], axis[0]])
    velocity, offset = (
        state.robot.velocity[3],
        state.agents.position[3, 4] - state.robot.position[3],
    )
    assert np.allclose(
        seen.robot[3],
        [np.linalg.norm(ahead), 1.0, 0.0, 0.3, velocity @ axis, velocity @ side],
        atol=1e-6,
    )
    assert np.allclose(
        seen.others[3, 4],
        [
            offset @ axis,
            offset @ side,
            state.agents.velocity[3, 4] @ axis,
            state.agents.velocity[3, 4] @ side,
            state.agents.radius[3, 4],
            np.linalg.norm(offset),
            state.agents.radius[3, 4] + 0.3,
        ],
        atol=1e-6,
    )


def test_the_features_of_padding_are_zero_whatever_it_holds():
    state, _ = scene()
    state.agents.valid[:, 2] = False
    state.agents.position[:, 2] = np.nan
    seen = observe(state)
    assert (seen.others[:, 2] == 0).all() and not seen.mask[:, 2].any()


def test_a_robot_on_its_goal_has_finite_features():
    state, _ = scene()
    state.robot.goal[:] = state.robot.position
    assert np.isfinite(observe(state).robot).all() and np.isfinite(observe(state).others).all()
