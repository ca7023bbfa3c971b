"""Laws of the robot-centred features."""

import dataclasses
import math

import numpy as np
import pytest

from socialnav_core.policies import observe
from socialnav_core.simulation import make_scenario, Simulator


def scene():
    simulator = Simulator(make_scenario('hard'), 16)
    state = simulator.reset(seed=2)
    return simulator.step(np.tile([0.5, 0.2], (16, 1)))[0], state


def turned(state, angle, shift):
    """Return the worlds turned and shifted as a whole."""
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    return dataclasses.replace(
        state,
        robot_position=state.robot_position @ turn + shift,
        robot_velocity=state.robot_velocity @ turn,
        robot_heading=state.robot_heading + angle,
        robot_goal=state.robot_goal @ turn + shift,
        position=state.position @ turn + shift,
        velocity=state.velocity @ turn,
    )


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
def test_turning_and_shifting_the_world_changes_nothing(kinematics):
    state, _ = scene()
    before = observe(state, kinematics)
    after = observe(turned(state, 0.7, np.array([3.0, -1.0])), kinematics)
    assert np.allclose(before.robot, after.robot, atol=1e-5)
    assert np.allclose(before.others, after.others, atol=1e-5)


def test_features_are_those_of_the_definition():
    state, _ = scene()
    seen = observe(state)
    ahead = state.robot_goal[3] - state.robot_position[3]
    axis = ahead / np.linalg.norm(ahead)
    side = np.array([-axis[1], axis[0]])
    velocity, offset = state.robot_velocity[3], state.position[3, 4] - state.robot_position[3]
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
            state.velocity[3, 4] @ axis,
            state.velocity[3, 4] @ side,
            state.radius[3, 4],
            np.linalg.norm(offset),
            state.radius[3, 4] + 0.3,
        ],
        atol=1e-6,
    )


def test_the_features_of_padding_are_zero_whatever_it_holds():
    state, _ = scene()
    state.valid[:, 2] = False
    state.position[:, 2] = np.nan
    seen = observe(state)
    assert (seen.others[:, 2] == 0).all() and not seen.mask[:, 2].any()


def test_a_robot_on_its_goal_has_finite_features():
    state, _ = scene()
    state.robot_goal[:] = state.robot_position
    assert np.isfinite(observe(state).robot).all() and np.isfinite(observe(state).others).all()
