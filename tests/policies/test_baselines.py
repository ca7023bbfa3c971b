"""Laws of the baselines: social forces, and the sampler with the costs of the search."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.evaluation import evaluate
from socialnav_core.policies import load_policy
from socialnav_core.policies.mppi import make_noise, MppiConfig
from socialnav_core.simulation import make_scenario, Simulator

EMPTY = dataclasses.replace(make_scenario('hard'), pedestrians=0, obstacles=0)
ALONE = dataclasses.replace(make_scenario('hard'), pedestrians=1, obstacles=0)
HARD = make_scenario('hard')
BASELINES = ('social_force', 'mppi')


@pytest.mark.parametrize('model', BASELINES)
def test_a_baseline_arrives_in_an_empty_room(model):
    assert evaluate(load_policy(model), EMPTY, 20).success_rate == 1.0


@pytest.mark.parametrize('model', BASELINES)
def test_a_baseline_does_better_among_people_than_a_blind_robot(model):
    blind, baseline = (
        evaluate(load_policy(name), HARD, 40).success_rate for name in ('straight_line', model)
    )
    assert baseline > blind + 0.2


@pytest.mark.parametrize('model', BASELINES)
def test_no_command_is_faster_than_the_robot_likes(model):
    state = Simulator(HARD, 20).reset(seed=4)
    speed = np.linalg.norm(load_policy(model).act(state), axis=1)
    assert (speed <= HARD.robot_preferred_speed + 1e-9).all() and speed.max() > 0.2


@pytest.mark.parametrize('model', BASELINES)
def test_padding_changes_nothing(model):
    state = Simulator(HARD, 3).reset(seed=4)
    nobody = state.agents.take(np.zeros((3, 2), int))
    nobody.valid[:] = False
    nobody.position[:] = state.robot.position[:, None]
    padded = dataclasses.replace(state, agents=state.agents.append(nobody))
    policy = load_policy(model)
    commands = policy.act(state)
    policy.reset()
    np.testing.assert_allclose(policy.act(padded), commands, atol=1e-12)


def test_the_sampler_decides_alike_whatever_runs_beside_it():
    alone, together = (evaluate(load_policy('mppi'), ALONE, 5, batch_size=n) for n in (1, 5))
    np.testing.assert_array_equal(alone.records.time, together.records.time)


def test_one_sequence_is_the_plan_itself_and_the_noise_becomes_smaller():
    noise = make_noise(MppiConfig(), 12)
    assert not noise[:, 0].any()
    assert (np.diff(noise[:, 1:].std(axis=(1, 2, 3))) < 0).all()


@pytest.mark.parametrize(
    ('model', 'setting'),
    [('social_force', 'reach'), ('mppi', 'temperature'), ('mppi', 'deviation')],
)
def test_settings_that_cannot_be_are_refused(model, setting):
    with pytest.raises(ConfigError, match=setting):
        load_policy(model, **{setting: 0.0})


def test_people_of_the_social_force_crowd_give_way_to_each_other():
    crowd = dataclasses.replace(make_scenario('crowd20'), crowd='social_force', pedestrians=8)
    deepest = {}
    for name in ('social_force', 'non_reactive'):
        simulator = Simulator(dataclasses.replace(crowd, crowd=name), 10, autoreset='disabled')
        simulator.reset()
        simulator._episodes.state.robot.position[:] = 7.0
        least = np.inf
        for _ in range(40):
            agents = simulator.step(np.zeros((10, 2)))[4]['final_state'].agents
            between = np.linalg.norm(
                agents.position[:, :, None] - agents.position[:, None], axis=-1
            )
            between[:, np.arange(8), np.arange(8)] = np.inf
            least = min(least, between.min())
        deepest[name] = least
    assert deepest['social_force'] > deepest['non_reactive'] + 0.1
