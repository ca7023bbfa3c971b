"""What goes wrong around a robot must stop it, and what only looks odd must not."""

import math

from builtin_interfaces.msg import Time
from helpers.driving import Drive, drives_among_any_number
from helpers.graph import open_graph
from helpers.managed import change_parameter, DOUBLE
from helpers.robot import speed
from helpers.worlds import random_state
import numpy as np
import pytest

from socialnav_msgs.msg import AgentState

pytestmark = pytest.mark.usefixtures('repetition')


@pytest.fixture(scope='module')
def drive():
    """Yield a robot that all tests of this file drive in turn."""
    with open_graph() as graph:
        yield Drive(graph).start()


def change_of(name, path, value):
    """Return a function that changes one field in the message of one topic."""

    def change(messages):
        owner = messages[name]
        *way, last = path.split('.')
        for step in way:
            owner = owner[int(step)] if step.isdigit() else getattr(owner, step)
        setattr(owner, last, value)

    return change


BAD_FIELDS = [
    ('pedestrian nan', 'pedestrians', 'agents.0.position.x', math.nan),
    ('pedestrian inf', 'pedestrians', 'agents.1.velocity.y', math.inf),
    ('radius negative', 'pedestrians', 'agents.0.radius', -0.3),
    ('pedestrians elsewhere', 'pedestrians', 'header.frame_id', 'camera'),
    ('list too long', 'pedestrians', 'agents', [AgentState(id=number) for number in range(5000)]),
    ('obstacle nan', 'obstacles', 'agents.0.radius', math.nan),
    ('odom inf', 'odom', 'pose.pose.position.y', -math.inf),
    ('odom far', 'odom', 'pose.pose.position.x', 1e300),
    ('no rotation', 'odom', 'pose.pose.orientation.w', 7.0),
    ('speed nan', 'odom', 'twist.twist.linear.x', math.nan),
    ('turn rate inf', 'odom', 'twist.twist.angular.z', math.inf),
    ('twist elsewhere', 'odom', 'child_frame_id', 'camera'),
    ('no stamps', 'odom', 'header.stamp', Time()),
    ('goal nan', 'goal_pose', 'pose.position.x', math.nan),
    ('goal elsewhere', 'goal_pose', 'header.frame_id', 'map'),
]


def test_a_field_that_cannot_be_stops_the_robot_and_the_next_good_one_lets_it_go_on(drive):
    state = random_state(0)
    for fault, name, path, value in BAD_FIELDS:
        drive.moves(state)
        drive.shows(fault, state, change=change_of(name, path, value))
    drive.moves(state)


def test_when_one_input_stops_the_robot_stops_only_where_that_input_ages(drive):
    state = random_state(0)
    for fault, name in (('odom stops', 'odom'), ('pedestrians stop', 'pedestrians')):
        drive.moves(state)
        drive.shows(fault, state, without=[name])
    for name in ('obstacles', 'goal_pose'):
        drive.moves(state)
        drive.graph.spin(0.7)
        drive.moves(state, f'{name} stopped', without=[name])
    assert change_parameter(
        drive.graph, 'obstacles_timeout', type=DOUBLE, double_value=0.4
    ).successful
    drive.shows('obstacles stop', state, without=['obstacles'])
    assert change_parameter(
        drive.graph, 'obstacles_timeout', type=DOUBLE, double_value=0.0
    ).successful
    drive.moves(state, 'obstacles do not age any more', without=['obstacles'])


def test_a_clock_that_jumps_stops_the_robot_and_the_right_time_lets_it_go_on(drive):
    state = random_state(0)
    drive.moves(state)
    drive.shows('stamps of the past', state, shift=-5.0)
    drive.shows('stamps of the future', state, shift=5.0)
    drive.moves(state)


def test_any_number_of_agents_with_any_ids_can_be_driven_among(drive):
    drives_among_any_number(drive)


def test_a_goal_within_an_obstacle_is_approached_and_nothing_breaks(drive):
    state = random_state(0, pedestrians=0, obstacles=1)
    state.agents.position[:] = state.robot.goal[:, None]
    drive.moves(state)
    beside = state.robot.goal - np.array([[state.agents.radius[0, 0] + 0.31, 0.0]])
    state = state.with_robot(position=beside, velocity=np.zeros((1, 2)))
    drive.commands.clear()
    for _ in range(20):
        drive.robot.publish(state)
        drive.graph.spin(0.05)
    assert len(drive.commands) > 5
    assert drive.health[-1].status[0].message.startswith('driving')


def test_a_goal_that_changes_ten_times_a_second_is_followed(drive):
    state = random_state(0)
    drive.moves(state)
    drive.commands.clear()
    for number in range(20):
        angle = number * 0.3
        goal = state.robot.position + 5.0 * np.array([[math.cos(angle), math.sin(angle)]])
        drive.robot.publish(state.with_robot(goal=goal))
        drive.graph.spin(0.1)
    assert len(drive.commands) > 10 and all(map(speed, drive.commands[1:]))


def test_an_obstacle_that_appears_in_the_way_is_not_driven_into(drive):
    free = random_state(0, pedestrians=0, obstacles=1)
    free.robot.position[:], free.robot.velocity[:], free.robot.heading[:] = 0.0, 0.0, 0.0
    free.robot.goal[:], free.agents.radius[:] = [[5.0, 0.0]], 0.5
    free.agents.position[:] = [[[0.0, 5.0]]]
    blocked = free.with_agents(position=np.array([[[1.0, 0.0]]]))
    for state, may_go_on in ((free, True), (blocked, False), (free, True)):

        def reacts(state=state, may_go_on=may_go_on):
            drive.robot.publish(state)
            drive.graph.spin(0.05)
            return drive.commands and (drive.commands[-1].linear.x > 0.9) == may_go_on

        drive.graph.wait(reacts, 'way ahead' if may_go_on else 'reaction to the obstacle')
    assert drive.health[-1].status[0].message.startswith('driving')
