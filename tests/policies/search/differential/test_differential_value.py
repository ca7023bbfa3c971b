"""Laws of the value at the horizon of the search for a differential drive."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import SearchConfig
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.config.policy import PolicyConfig
from socialnav_core.policies import load_policy
from socialnav_core.policies.search.checkpoint import save_planner
from socialnav_core.policies.search.differential.policy import DifferentialSearchPolicy
from socialnav_core.policies.search.terminal import observe_horizon
from socialnav_core.training.randomness import initial_network
from tests.policies.search.differential.differential_worlds import DRIVE, facing, LIMITS
from tests.policies.search.search_worlds import discs

SETTINGS = SearchConfig(kinematics='differential')


class Sideways:
    """A value that prefers to be on the left, and keeps what it was asked."""

    def __init__(self, slope):
        self.slope, self.horizon = slope, None

    def costs(self, horizon):
        self.horizon = horizon
        return -self.slope * horizon.positions[..., 1]

    def attention(self, state):
        return None


@pytest.fixture
def state():
    return facing(
        agents=discs((5.0, 0.4, 0.3), velocity=[(-0.5, 0.0)]), goal=(9.0, 0.0), speed=0.5
    )


def test_a_value_that_knows_nothing_changes_nothing(state):
    plain = DifferentialSearchPolicy(SETTINGS)
    valued = DifferentialSearchPolicy(SETTINGS, value=Sideways(0.0))
    np.testing.assert_array_equal(valued.act(state, LIMITS), plain.act(state, LIMITS))
    np.testing.assert_array_equal(valued.plan, plain.plan)
    np.testing.assert_array_equal(valued.expected_cost, plain.expected_cost)


def test_the_robot_turns_to_where_the_value_wants_it_within_its_limits(state):
    for slope in (5.0, -5.0):
        policy = DifferentialSearchPolicy(SETTINGS, value=Sideways(slope))
        command = policy.act(state, LIMITS)
        assert np.sign(command[0, 1]) == np.sign(slope)
        present = DRIVE.present_command(state.robot)
        reachable = DRIVE.reachable(command, present, LIMITS, LIMITS.period)
        np.testing.assert_allclose(command, reachable, atol=1e-9)
        moved, _, _ = DRIVE.move(state.robot.heading, command, LIMITS.period)
        np.testing.assert_allclose(policy.plan[:, 0], state.robot.position + moved, atol=1e-9)


def test_the_network_sees_where_the_robot_looks_and_how_fast_it_drives(state):
    value = Sideways(0.1)
    patient = dataclasses.replace(SETTINGS, horizon=1.0, candidate_slack=4.0)
    DifferentialSearchPolicy(patient, value=value).act(state, LIMITS)
    horizon, seen = value.horizon, observe_horizon(value.horizon)
    offset = horizon.subgoals[horizon.used] - horizon.positions[horizon.used]
    bearing = horizon.headings[horizon.used] - np.arctan2(offset[:, 1], offset[:, 0])
    np.testing.assert_allclose(np.sin(seen.robot[:, 2]), np.sin(bearing), atol=1e-5)
    speeds = horizon.speeds[horizon.used]
    np.testing.assert_allclose(seen.robot[:, 4], speeds * np.cos(bearing), atol=1e-5)
    assert len(np.unique(speeds.round(3))) > 1 and np.abs(bearing).max() > 0.1


def test_what_is_left_is_what_the_search_reckons():
    alone = facing(goal=(9.0, 0.0), speed=1.0)
    policy = DifferentialSearchPolicy(SETTINGS)
    policy.act(alone, LIMITS)
    left = policy.time_left(alone, LIMITS)
    np.testing.assert_allclose(left, policy.expected_cost, atol=0.05)
    turned = policy.time_left(facing(heading=2.0, goal=(9.0, 0.0), speed=1.0), LIMITS)
    assert turned[0] > left[0] + 0.5


def test_a_planner_for_a_differential_drive_is_loaded_as_one(tmp_path, state):
    config = PlannerConfig('turning', policy=SETTINGS)
    save_planner(tmp_path / 'turning', initial_network(PolicyConfig(), 1), config)
    policy = load_policy(tmp_path / 'turning')
    assert isinstance(policy, DifferentialSearchPolicy)
    assert policy.description.name == 'turning'
    assert np.isfinite(policy.act(state, LIMITS)).all()
    np.testing.assert_allclose(policy.attention(state).sum(axis=1), 1.0, atol=1e-5)
    with pytest.raises(ValueError, match='fixed'):
        load_policy(tmp_path / 'turning', kinematics='holonomic')
