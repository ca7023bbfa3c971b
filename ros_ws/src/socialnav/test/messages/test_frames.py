"""Inputs in other frames; a function stands in for tf2."""

import math

from helpers.controllers import Recorder, SECOND, SETTINGS
from helpers.worlds import BODY, messages_of, quaternion_of, random_state
import numpy as np
import pytest

from socialnav.control.controller import Controller
from socialnav.messages.conversions import crowd_state
from socialnav_core.sensing import HERE, Pose

PLACEMENT = Pose(1.0, -2.0, 0.7)
VECTORS = ('robot.velocity', 'agents.velocity')
POINTS = ('robot.position', 'robot.goal', 'agents.position')


def test_a_placement_finds_again_what_it_placed():
    points = np.random.default_rng(0).normal(size=(3, 4, 2))
    np.testing.assert_allclose(PLACEMENT.found(PLACEMENT.placed(points)), points)


def test_a_placement_turns_counter_clockwise():
    quarter = Pose(heading=math.pi / 2)
    np.testing.assert_allclose(quarter.placed(np.array([1.0, 0.0])), [0.0, 1.0], atol=1e-12)


def test_a_frame_within_a_frame_places_as_one_after_the_other():
    points = np.random.default_rng(0).normal(size=(4, 2))
    inner = Pose(0.3, 0.4, -1.0)
    np.testing.assert_allclose(
        PLACEMENT.of(inner).placed(points), PLACEMENT.placed(inner.placed(points))
    )
    assert PLACEMENT.of(HERE) == PLACEMENT


def test_a_world_told_in_another_frame_is_the_same_world():
    told = random_state(0)
    state = crowd_state(
        *(messages_of(told, SECOND, 'map')[name] for name in (
            'odom', 'goal_pose', 'pedestrians', 'obstacles',
        )),
        BODY, 'odom', locate=lambda frame, source, stamp: PLACEMENT,
    )  # fmt: skip
    for name in POINTS:
        np.testing.assert_allclose(state.arrays()[name], PLACEMENT.placed(told.arrays()[name]))
    for name in VECTORS:
        np.testing.assert_allclose(state.arrays()[name], PLACEMENT.turned(told.arrays()[name]))
    np.testing.assert_allclose(np.sin(state.robot.heading - told.robot.heading), np.sin(0.7))


def test_what_moves_is_placed_at_its_stamp_and_what_stands_by_the_newest_placement():
    asked = {}

    def locate(frame, source, stamp):
        asked[source] = (frame, stamp)
        return HERE

    messages = messages_of(random_state(0), SECOND)
    for name, message in messages.items():
        message.header.frame_id = f'frame of {name}'
    controller = Controller(Recorder(), SETTINGS, steady=lambda: 0.0, locate=locate)
    for name, message in messages.items():
        controller.store(name, message)
    assert controller.decide(SECOND).reason is None
    assert asked == {
        'frame of odom': ('odom', SECOND),
        'frame of pedestrians': ('odom', SECOND),
        'frame of goal_pose': ('odom', 0),
        'frame of obstacles': ('odom', 0),
    }


def test_where_nobody_knows_a_frame_the_robot_stands_and_says_what_is_missing():
    def locate(frame, source, stamp):
        raise LookupError('tf2_ros is not installed')

    messages = messages_of(random_state(0), SECOND)
    messages['goal_pose'].header.frame_id = 'map'
    controller = Controller(Recorder(), SETTINGS, steady=lambda: 0.0, locate=locate)
    for name, message in messages.items():
        controller.store(name, message)
    decision = controller.decide(SECOND)
    assert decision.command.tolist() == [0.0, 0.0]
    assert decision.reason == "goal_pose: in frame 'map', but tf2_ros is not installed"


@pytest.mark.parametrize('heading', [0.0, 1.0, -3.0])
def test_inputs_in_the_planning_frame_ask_nobody(heading):
    messages = messages_of(random_state(0), SECOND)
    messages['odom'].pose.pose.orientation = quaternion_of(heading)
    controller = Controller(Recorder(), SETTINGS, steady=lambda: 0.0)
    for name, message in messages.items():
        controller.store(name, message)
    assert controller.decide(SECOND).reason is None
