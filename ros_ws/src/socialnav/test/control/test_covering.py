"""Laws of agents in the robot's own place."""

from helpers.controllers import controller_of, LOCKSTEP, Recorder, SECOND
from helpers.worlds import apart, random_state
import numpy as np
import pytest

from socialnav.control.covering import covering_complaint


def world(distance, static):
    """Return a world with one agent at a distance from a robot of 0.3 m, its radius 0.35 m."""
    state = random_state(0, pedestrians=int(not static), obstacles=int(static))
    state.agents.position[:] = state.robot.position[:, None] + [distance, 0.0]
    state.agents.radius[:] = 0.35
    return state


@pytest.mark.parametrize(
    ('distance', 'static', 'words'),
    [
        (0.0, False, 'a pedestrian where the robot is (0.00 m'),
        (0.34, False, 'a pedestrian where the robot is'),
        (0.36, False, None),
        (0.2, True, 'an obstacle within the robot (-0.15 m'),
        (0.49, True, 'footprint_radius'),
        (0.51, True, None),
    ],
)
def test_an_agent_in_the_place_of_the_robot_is_named(distance, static, words):
    found = covering_complaint(world(distance, static))
    assert found is None if words is None else words in found


def test_a_robot_that_is_listed_among_the_people_stands_and_says_so():
    policy = Recorder()
    decision = controller_of(policy, state=world(0.0, static=False)).decide(SECOND)
    assert 'does the tracker take the robot for a person?' in decision.reason
    assert not decision.command.any()


def test_in_lockstep_the_world_is_as_the_simulator_has_it():
    policy = Recorder()
    controller = controller_of(policy, LOCKSTEP, state=world(0.1, static=True))
    assert controller.decide(SECOND).reason is None


def test_nobody_covers_a_robot_that_keeps_its_distance():
    assert all(covering_complaint(apart(random_state(seed))) is None for seed in range(20))
    empty = random_state(0, pedestrians=0, obstacles=0)
    assert empty.agents.position.shape == (1, 0, 2) and np.isfinite(empty.robot.radius).all()
    assert covering_complaint(empty) is None
