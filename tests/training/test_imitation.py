"""Laws of imitation."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.policies import observe, OrcaPolicy
from socialnav_core.simulation import make_scenario, Outcome, Simulator
from socialnav_core.training.imitation import collect_demonstrations, imitate
from socialnav_core.training.randomness import generator, initial_network, Purpose

EPISODES = 10


def demonstrate(scenario, worlds, demonstrator=None):
    """Return demonstrations of a few cases."""
    simulator = Simulator(scenario, worlds)
    return collect_demonstrations(simulator, demonstrator or OrcaPolicy(0.15), EPISODES, seed=1)


class FullSpeed:
    """Drives straight at the goal at 1 m/s."""

    def act(self, state, limits=None):
        """Return the commands."""
        ahead = state.robot.goal - state.robot.position
        return ahead / np.maximum(np.linalg.norm(ahead, axis=1, keepdims=True), 1e-9)

    def reset(self, worlds=None):
        """Do nothing."""


def start_robots(scenario):
    """Return what the robots of the cases see at their start, (EPISODES, 6)."""
    simulator = Simulator(scenario, EPISODES)
    return observe(simulator.reset(seed=1, split='train', cases=range(EPISODES))).robot


def test_demonstrations_are_exactly_the_cases_asked_for():
    scenario = make_scenario('simple')
    found = demonstrate(scenario, worlds=3)
    succeeded = found.outcome != Outcome.TIMEOUT
    robot = found.observation.robot
    starts = robot[np.isin(robot[:, 0], start_robots(scenario)[:, 0])]
    assert (found.outcome != Outcome.NONE).all()
    np.testing.assert_array_equal(
        np.sort(starts[:, 0]), np.sort(start_robots(scenario)[succeeded, 0])
    )


def test_demonstrations_do_not_depend_on_the_number_of_worlds():
    scenario = make_scenario('simple')
    few, many = demonstrate(scenario, worlds=2), demonstrate(scenario, worlds=16)
    np.testing.assert_array_equal(few.outcome, many.outcome)
    np.testing.assert_array_equal(np.sort(few.returns), np.sort(many.returns))


def test_returns_follow_from_the_way_to_the_goal_where_nothing_disturbs():
    scenario = dataclasses.replace(make_scenario('simple'), pedestrians=0, obstacles=0)
    scenario = dataclasses.replace(
        scenario, reward=dataclasses.replace(scenario.reward, discomfort_factor=0.0)
    )
    found = demonstrate(scenario, 4, FullSpeed())
    steps = np.ceil((found.observation.robot[:, 0] - scenario.goal_tolerance) / 0.25)
    exact = (found.observation.robot[:, 0] - scenario.goal_tolerance) % 0.25
    inside = (exact > 0.01) & (exact < 0.24)
    assert inside.any()
    expected = scenario.discount ** (steps[inside] - 1)
    assert found.returns[inside] == pytest.approx(expected, rel=1e-5)


def test_episodes_that_ran_out_of_time_are_left_out():
    scenario = dataclasses.replace(make_scenario('simple'), time_limit=9.0)
    found = demonstrate(scenario, worlds=4)
    late = found.outcome == Outcome.TIMEOUT
    assert 0 < late.sum() < EPISODES
    distances = start_robots(scenario)[late, 0]
    assert not np.isin(distances, found.observation.robot[:, 0]).any()


def test_imitation_brings_values_nearer_to_the_returns(tiny_config):
    found = demonstrate(make_scenario('simple'), worlds=5)
    network = initial_network(tiny_config.policy, seed=0)
    losses = [
        imitate(network, found, tiny_config.training, generator(0, Purpose.IMITATION, epoch))
        for epoch in range(8)
    ]
    assert losses[-1] < 0.5 * losses[0]
