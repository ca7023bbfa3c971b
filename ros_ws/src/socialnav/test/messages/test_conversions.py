"""Laws of the way from a state to messages and back."""

import math

from helpers.worlds import BODY, messages_of, quaternion_of, random_state
import numpy as np
import pytest

from socialnav.messages.conversions import ConversionError, crowd_state
from socialnav_core.simulation.kinematics.angles import rotated


def back(messages: dict, time: float = 0.5):
    """Return the state that messages tell."""
    order = (messages[name] for name in ('odom', 'goal_pose', 'pedestrians', 'obstacles'))
    return crowd_state(*order, BODY, 'odom', time)


@pytest.mark.parametrize('seed', range(5))
def test_state_to_messages_to_state_is_the_identity(seed):
    state = random_state(seed)
    again = back(messages_of(state))
    for name, expected in state.arrays().items():
        actual = again.arrays()[name]
        assert expected.shape == actual.shape and expected.dtype == actual.dtype, name
        np.testing.assert_allclose(actual, expected, rtol=0, atol=1e-12, err_msg=name)


def test_a_world_without_agents_is_a_world():
    state = back(messages_of(random_state(0, pedestrians=0, obstacles=0)))
    assert state.agents.position.shape == (1, 0, 2) and state.agents.static.shape == (1, 0)


def test_obstacles_may_be_missing():
    messages = messages_of(random_state(0)) | {'obstacles': None}
    assert back(messages).agents.count == 3


def test_the_twist_of_odometry_is_in_the_frame_of_the_robot():
    state = random_state(0)
    state.robot.heading[:] = math.pi / 2
    state.robot.velocity[:] = [0.0, 1.0]
    linear = messages_of(state)['odom'].twist.twist.linear
    assert (linear.x, linear.y) == pytest.approx((1.0, 0.0))


def test_rotating_there_and_back_changes_nothing():
    vector = np.array([0.3, -1.2])
    np.testing.assert_allclose(rotated(rotated(vector, 0.7), -0.7), vector, atol=1e-15)


@pytest.mark.parametrize('bad', [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize('name', ['odom', 'goal_pose', 'pedestrians', 'obstacles'])
def test_a_position_that_is_not_finite_is_refused_by_name(name, bad):
    messages = messages_of(random_state(0))
    message = messages[name]
    places = {'odom': lambda: message.pose.pose, 'goal_pose': lambda: message.pose}
    places.get(name, lambda: message.agents[1])().position.y = bad
    with pytest.raises(ConversionError, match=f'^{name}: position'):
        back(messages)


def test_an_unknown_velocity_of_a_pedestrian_is_refused():
    messages = messages_of(random_state(0))
    messages['pedestrians'].agents[0].velocity.x = math.nan
    with pytest.raises(ConversionError, match='pedestrians: velocity'):
        back(messages)


def test_a_negative_radius_is_refused():
    messages = messages_of(random_state(0))
    messages['pedestrians'].agents[0].radius = -0.1
    with pytest.raises(ConversionError, match='negative radius'):
        back(messages)


@pytest.mark.parametrize('name', ['odom', 'goal_pose', 'pedestrians', 'obstacles'])
def test_a_foreign_frame_is_refused_by_name(name):
    messages = messages_of(random_state(0))
    messages[name].header.frame_id = 'camera'
    with pytest.raises(ConversionError, match=f"{name}: in frame 'camera'"):
        back(messages)


def test_an_orientation_that_was_never_set_is_refused():
    messages = messages_of(random_state(0))
    messages['odom'].pose.pose.orientation = quaternion_of(0.0)
    messages['odom'].pose.pose.orientation.w = 0.0
    with pytest.raises(ConversionError, match='orientation'):
        back(messages)
