"""Laws of the training of a planner."""

import numpy as np
import pytest
import torch

from socialnav_core.config import ConfigError, make_scenario, SearchConfig
from socialnav_core.config.planner import PlannerConfig, PlannerTrainingConfig
from socialnav_core.policies import SearchPolicy
from socialnav_core.policies.search.checkpoint import load_planner
from socialnav_core.policies.search.terminal import AGENTS
from socialnav_core.simulation import Outcome
from socialnav_core.states import Observation
from socialnav_core.training import TrainingInterrupted
from socialnav_core.training.planner import learning, train_planner
from socialnav_core.training.planner.driving import drive, examples_of, Preference
from socialnav_core.training.planner.worlds import draw_world

SEARCH = SearchConfig(headings=8, horizon=1.0)
TINY = PlannerTrainingConfig(
    rounds=2, groups=1, episodes=3, validation_groups=1, updates=3, batch_size=8
)


def tiny(**changes):
    return PlannerConfig('tiny', policy=SEARCH, training=TINY, **changes)


def weights_of(folder):
    return load_planner(folder).network.state_dict()


def seen(count):
    return Observation(
        np.zeros((count, 6), np.float32),
        np.zeros((count, AGENTS, 7), np.float32),
        np.zeros((count, AGENTS), bool),
    )


def test_a_cost_is_what_followed_less_the_time_of_the_way():
    costs = [np.array([0.25, 0.25]), np.array([0.5, 0.25]), np.array([0.25, 8.25])]
    outcome = np.array([Outcome.GOAL, Outcome.COLLISION_PEDESTRIAN])
    moments = [(seen(2), np.array([0.5, 2.0]), np.arange(2), 1)]
    examples = examples_of(moments, costs, outcome, TINY)
    np.testing.assert_allclose(examples.cost, [0.25, 6.5])


def test_what_a_time_out_would_have_cost_counts_only_where_it_is_at_the_limit():
    costs = [np.array([5.0]), np.array([7.0])]
    moments = [(seen(1), np.array([1.0]), np.arange(1), step) for step in (0, 1)]
    examples = examples_of(moments, costs, np.array([Outcome.TIMEOUT]), TINY)
    np.testing.assert_allclose(examples.cost, [10.0])


def test_examples_come_from_all_but_the_first_seconds_of_each_episode():
    scenario = make_scenario('simple')
    came = drive(SearchPolicy(SEARCH), scenario, np.arange(4), 0, 'train', TINY)
    steps = np.round(came.time / scenario.time_step).astype(int)
    ahead = round(SEARCH.horizon / scenario.time_step)
    known = steps[came.outcome != Outcome.TIMEOUT]
    assert len(came.examples.cost) == sum(len(range(ahead, count, TINY.stride)) for count in known)
    assert np.isfinite(came.examples.observation.others).all()


def test_a_preference_leads_elsewhere():
    scenario = make_scenario('crowd20')
    draws = np.random.default_rng(1)
    exploring = SearchPolicy(SEARCH, value=Preference(None, 1.0, 3, draws))
    there = drive(exploring, scenario, np.arange(3), 0, 'train', TINY)
    plain = drive(SearchPolicy(SEARCH), scenario, np.arange(3), 0, 'train', TINY)
    assert (there.time != plain.time).any()


def test_drawn_worlds_differ_in_everything():
    worlds = [draw_world(0.0, np.random.default_rng(seed)) for seed in range(60)]
    assert {world.pedestrians for world in worlds} >= {0, 1, 30} or len(
        {world.pedestrians for world in worlds}
    ) > 15
    assert {world.crowd for world in worlds} == {'orca', 'non_reactive'}
    assert len({world.robot_preferred_speed for world in worlds}) == 60


def test_a_run_leaves_a_planner(tmp_path):
    train_planner(tiny(), tmp_path / 'run', progress=False)
    assert load_planner(tmp_path / 'run').config == tiny()
    rows = (tmp_path / 'run' / 'progress.csv').read_text().splitlines()
    assert len(rows) == 3 and rows[0].startswith('round,examples,loss,success_rate')
    with pytest.raises(ConfigError, match='not empty'):
        train_planner(tiny(), tmp_path / 'run', progress=False)


def test_a_run_that_was_stopped_ends_with_the_same_weights(tmp_path, monkeypatch):
    train_planner(tiny(), tmp_path / 'whole', progress=False)
    counted = learning.stop_or_count

    def stop_in_round_two(interruption, bar, run, out):
        interruption.number = 2 * (run.rounds == 1)
        counted(interruption, bar, run, out)

    with monkeypatch.context() as patch:
        patch.setattr(learning, 'stop_or_count', stop_in_round_two)
        with pytest.raises(TrainingInterrupted, match='1 of 2 rounds'):
            train_planner(tiny(), tmp_path / 'stopped', progress=False)
    train_planner(tiny(), tmp_path / 'stopped', resume=True, progress=False)
    whole, stopped = weights_of(tmp_path / 'whole'), weights_of(tmp_path / 'stopped')
    assert all(torch.equal(whole[name], stopped[name]) for name in whole)


def test_another_configuration_cannot_go_on_with_a_run(tmp_path, monkeypatch):
    def stop(interruption, bar, run, out):
        interruption.number = 2 * (run.rounds == 1)
        counted(interruption, bar, run, out)

    counted = learning.stop_or_count
    monkeypatch.setattr(learning, 'stop_or_count', stop)
    with pytest.raises(TrainingInterrupted):
        train_planner(tiny(), tmp_path / 'run', progress=False)
    with pytest.raises(ConfigError, match='seed'):
        train_planner(tiny(seed=1), tmp_path / 'run', resume=True, progress=False)
