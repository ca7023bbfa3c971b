"""Laws of the robot's motion and of the action sets."""

import math

import numpy as np
import pytest

from socialnav_core.config import KINEMATICS, PolicyConfig
from socialnav_core.simulation.kinematics import BY_NAME, DifferentialDrive, Holonomic


def test_a_holonomic_robot_moves_by_its_command_and_keeps_its_heading():
    command = np.array([[0.6, -0.8]])
    displacement, velocity, heading = Holonomic().move(np.array([0.3]), command, 0.25)
    assert np.allclose(displacement, [[0.15, -0.2]])
    assert np.array_equal(velocity, command) and heading == [0.3]


def test_a_differential_drive_follows_the_arc_that_small_steps_approach():
    heading, command, steps = np.array([0.4]), np.array([[0.8, 1.7]]), 20000
    displacement, velocity, end = DifferentialDrive().move(heading, command, 0.5)
    position, angle = np.zeros(2), 0.4
    for _ in range(steps):
        position += 0.8 * np.array([math.cos(angle), math.sin(angle)]) * 0.5 / steps
        angle += 1.7 * 0.5 / steps
    assert np.allclose(displacement[0], position, atol=1e-4)
    assert end[0] == pytest.approx(angle)
    assert np.allclose(velocity[0], [0.8 * math.cos(angle), 0.8 * math.sin(angle)], atol=1e-9)


def test_a_differential_drive_without_turning_goes_straight():
    displacement, _, _ = DifferentialDrive().move(np.zeros(1), np.array([[1.0, 0.0]]), 0.25)
    assert np.allclose(displacement, [[0.25, 0.0]])


@pytest.mark.parametrize(('speeds', 'headings', 'actions'), [(2, 8, 17), (5, 16, 81), (2, 16, 33)])
def test_the_action_set_is_every_speed_in_every_heading_and_the_stop(speeds, headings, actions):
    commands = Holonomic().action_set(PolicyConfig(speeds=speeds, headings=headings))
    assert commands.shape == (actions, 2)
    assert (commands[0] == 0).all()
    assert len(np.unique(commands.round(9), axis=0)) == actions
    assert np.linalg.norm(commands, axis=-1).max() == pytest.approx(1.0)


def test_speeds_are_spaced_exponentially():
    norms = np.unique(np.linalg.norm(Holonomic().action_set(PolicyConfig()), axis=-1).round(9))
    assert np.allclose(norms, [0.0, (math.exp(0.5) - 1) / (math.e - 1), 1.0])


def test_turn_rates_do_not_grow_with_the_preferred_speed():
    actions = DifferentialDrive().action_set(PolicyConfig())
    scaled = DifferentialDrive().scale(actions, np.array([0.5, 2.0]))
    assert np.array_equal(scaled[0, :, 1], scaled[1, :, 1])
    assert np.allclose(scaled[1, :, 0], 4.0 * scaled[0, :, 0])


def test_every_name_of_the_settings_has_its_object():
    assert tuple(BY_NAME) == KINEMATICS


@pytest.mark.parametrize('kinematics', BY_NAME.values(), ids=BY_NAME)
def test_a_command_comes_back_from_the_base_and_from_a_twist(kinematics):
    command = np.array([0.6, -0.3])
    base = kinematics.to_base(command, 0.7)
    assert np.allclose(kinematics.from_base(base, 0.7), command)
    assert np.array_equal(kinematics.from_twist(*kinematics.twist(base)), base)


def test_a_base_takes_velocities_in_its_own_frame_and_speeds_as_they_are():
    command = np.array([0.0, 1.0])  # north, for a robot that looks north: ahead
    assert np.allclose(Holonomic().to_base(command, math.pi / 2), [1.0, 0.0])
    assert np.array_equal(DifferentialDrive().to_base(command, math.pi / 2), command)


def test_only_a_differential_drive_turns_and_only_a_holonomic_robot_moves_sideways():
    assert Holonomic().twist(np.array([0.5, 0.2])) == (0.5, 0.2, 0.0)
    assert DifferentialDrive().twist(np.array([0.5, 0.2])) == (0.5, 0.0, 0.2)


@pytest.mark.parametrize('kinematics', BY_NAME.values(), ids=BY_NAME)
def test_whoever_claims_to_go_straight_does_so(kinematics):
    command = np.array([0.8, 1.7])
    half, _, heading = kinematics.move(np.array(0.4), command, 0.5)
    whole, _, _ = kinematics.move(np.array(0.4), command, 1.0)
    assert np.allclose(2 * half, whole) == kinematics.straight
    assert (heading != 0.4) == kinematics.has_heading
