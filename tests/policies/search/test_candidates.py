"""Laws of the ways on between which a value at the horizon chooses."""

import numpy as np
import pytest

from socialnav_core.config import make_scenario, SearchConfig
from socialnav_core.policies import load_policy, SearchPolicy
from socialnav_core.policies.search.terminal import expected_state, observe_horizon
from socialnav_core.policies.value.observation import observe
from socialnav_core.simulation import Simulator
from tests.policies.search.search_worlds import discs, drive, gaps, world


class Sideways:
    """A value that prefers to be on the left, and keeps what it was asked."""

    def __init__(self, slope):
        self.slope, self.horizon = slope, None

    def costs(self, horizon):
        self.horizon = horizon
        return -self.slope * horizon.positions[..., 1]

    def attention(self, state):
        return None


def crowd(worlds=4, name='crowd20'):
    simulator = Simulator(make_scenario(name), worlds)
    state, policy = simulator.reset(seed=3, split='train'), load_policy('orca')
    for _ in range(6):
        state, *_ = simulator.step(policy.act(state))
    return state


def test_a_value_that_knows_nothing_changes_nothing():
    state, plain, valued = crowd(), SearchPolicy(), SearchPolicy(value=Sideways(0.0))
    np.testing.assert_array_equal(valued.act(state), plain.act(state))
    np.testing.assert_array_equal(valued.plan, plain.plan)
    np.testing.assert_array_equal(valued.expected_cost, plain.expected_cost)


def test_a_value_of_no_weight_is_never_asked():
    value = Sideways(1.0)
    SearchPolicy(SearchConfig(value_weight=0.0), value=value).act(crowd())
    assert value.horizon is None


def test_the_robot_turns_to_where_the_value_wants_it():
    state = world(goal=(9.0, 0.0))
    left = SearchPolicy(value=Sideways(5.0)).act(state)
    right = SearchPolicy(value=Sideways(-5.0)).act(state)
    assert left[0, 1] > 0.1 and right[0, 1] < -0.1


def test_a_way_that_is_worse_than_the_slack_is_never_taken():
    state = world(goal=(9.0, 0.0))
    policy = SearchPolicy(SearchConfig(candidate_slack=0.0), value=Sideways(100.0))
    np.testing.assert_allclose(policy.act(state), [[1.0, 0.0]], atol=1e-6)


def test_each_first_motion_is_weighed_once():
    value = Sideways(0.1)
    policy = SearchPolicy(value=value)
    state = crowd()
    policy.act(state)
    assert value.horizon.used.sum() > 8
    candidates = np.unique(value.horizon.positions[value.horizon.used], axis=0)
    assert len(candidates) == value.horizon.used.sum()


def test_no_more_ways_are_weighed_than_the_settings_allow():
    value = Sideways(0.1)
    SearchPolicy(SearchConfig(candidates=3), value=value).act(crowd())
    assert value.horizon.used.shape[1] == 3 and value.horizon.used.any()


def test_of_few_ways_the_cheapest_are_kept():
    few, many = Sideways(0.0), Sideways(0.0)
    state = crowd()
    first = SearchPolicy(SearchConfig(candidates=4), value=few)
    second = SearchPolicy(SearchConfig(candidates=34), value=many)
    np.testing.assert_array_equal(first.act(state), second.act(state))


def test_a_robot_that_arrives_within_the_horizon_is_left_alone():
    state = world(goal=(2.0, 0.0))
    value = Sideways(100.0)
    np.testing.assert_array_equal(SearchPolicy(value=value).act(state), SearchPolicy().act(state))
    assert not value.horizon.used.any()


def test_the_plan_is_that_of_the_way_that_was_chosen():
    policy = SearchPolicy(value=Sideways(0.2))
    state = crowd()
    command = policy.act(state)
    np.testing.assert_allclose(
        policy.plan[:, 0], state.robot.position + command * policy.settings.time_step
    )


def test_a_value_does_not_make_it_touch_anybody():
    state = world(discs((4.0, 0.1, 0.3), (3.0, 1.5, 0.4)), goal=(8.0, 0.0))
    states = drive(SearchPolicy(value=Sideways(0.2)), state)
    assert min(gaps(each).min() for each in states) > 0.0


def test_ways_on_lead_around_obstacles():
    state = world(discs((4.0, 0.2, 1.5), static=True), goal=(8.0, 0.0))
    distance, subgoal = SearchPolicy().ways_on(state, np.array([[[0.0, 0.0], [7.0, 0.0]]]))
    assert distance[0, 0] > 8.1
    assert distance[0, 1] == pytest.approx(1.0, abs=0.02)
    offset = subgoal[0] - [[0.0, 0.0], [7.0, 0.0]]
    np.testing.assert_allclose(np.hypot(*offset.T), distance[0])
    assert abs(np.arctan2(*offset[0, ::-1])) > 0.2
    np.testing.assert_allclose(subgoal[0, 1], [8.0, 0.0], atol=0.03)


def test_the_network_sees_people_where_they_are_expected():
    value = Sideways(0.1)
    policy = SearchPolicy(value=value)
    walking = discs((4.0, 2.0, 0.3), velocity=[(0.0, -1.0)])
    state = world(walking, goal=(9.0, 0.0))
    policy.act(state)
    expected = expected_state(state, policy.prediction, policy.last_layer)
    np.testing.assert_allclose(expected.agents.position[0, 0], [4.0, -1.0], atol=1e-9)
    np.testing.assert_allclose(expected.agents.velocity[0, 0], [0.0, -1.0], atol=1e-9)
    seen = observe_horizon(value.horizon)
    place = np.flatnonzero(value.horizon.used[0])[0]
    there = expected.with_robot(
        position=value.horizon.positions[:, place], goal=value.horizon.subgoals[:, place]
    )
    np.testing.assert_allclose(seen.others[0], observe(there).others[0], atol=1e-6)
    np.testing.assert_allclose(seen.robot[0], observe(there).robot[0], atol=1e-6)
