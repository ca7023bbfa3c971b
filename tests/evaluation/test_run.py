"""Evaluation runs each case once and measures it the same way however it is batched."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.evaluation import compare, evaluate
from socialnav_core.metrics import intrusions
from socialnav_core.policies import OrcaPolicy, StraightLinePolicy
from socialnav_core.simulation import make_scenario, Simulator

HARD = make_scenario('hard')


class Differential(StraightLinePolicy):
    kinematics = 'differential'


class Counting(StraightLinePolicy):
    def __init__(self):
        self.rows = 0

    def act(self, state, limits=None):
        self.rows += state.batch_size
        return super().act(state, limits)


@pytest.mark.parametrize('batch_size', [1, 7, 64])
def test_each_case_is_run_exactly_once(batch_size):
    records = evaluate(StraightLinePolicy(), HARD, 23, batch_size=batch_size).records
    np.testing.assert_array_equal(records.case_index, np.arange(23))
    assert (records.steps > 0).all()
    assert (records.outcome > 0).all()


def test_results_do_not_depend_on_the_batch_size():
    alone, together = (evaluate(OrcaPolicy(), HARD, 40, 5, batch_size=size) for size in (1, 16))
    for field in dataclasses.fields(alone.records):
        np.testing.assert_array_equal(
            getattr(alone.records, field.name), getattr(together.records, field.name), field.name
        )


def test_more_episodes_leave_the_first_cases_as_they_were():
    few, many = (evaluate(OrcaPolicy(), HARD, episodes, 2).records for episodes in (10, 30))
    np.testing.assert_array_equal(few.time, many.time[:10])


def test_seeds_and_splits_are_different_cases():
    times = [
        evaluate(StraightLinePolicy(), HARD, 20, seed, split).records.time
        for seed, split in ((0, 'test'), (1, 'test'), (0, 'validation'))
    ]
    assert (times[0] != times[1]).any()
    assert (times[0] != times[2]).any()


def test_a_policy_is_not_asked_about_idle_worlds():
    policy = Counting()
    result = evaluate(policy, HARD, 20, batch_size=8)
    assert policy.rows == result.records.steps.sum()


def test_records_agree_with_a_run_by_hand():
    simulator = Simulator(HARD, 1)
    state = simulator.reset(seed=3, cases=[4])
    policy, close, path = StraightLinePolicy(), 0, 0.0
    ended = False
    while not ended:
        command = policy.act(state)
        path += float(np.linalg.norm(command)) * HARD.time_step
        state, _, terminated, truncated, info = simulator.step(command)
        close += int(info['pedestrian_clearance'][0] < 0.2)
        ended = bool(terminated[0] | truncated[0])
    records = evaluate(policy, HARD, 6, 3).records
    assert records.outcome[4] == info['outcome'][0]
    assert records.time[4] == info['time'][0]
    assert records.path_length[4] == pytest.approx(path)
    assert intrusions(records)[4] == close


def test_the_mapping_has_every_field_that_readers_rely_on():
    result = evaluate(StraightLinePolicy(), HARD, 5, name='blind')
    values = result.to_mapping()
    assert result.success_rate == values['success_rate']
    assert {
        'model', 'scenario', 'seed', 'episodes', 'split', 'lookahead', 'screening',
        'success_rate', 'success_interval', 'collision_rate', 'collision_pedestrian_rate',
        'collision_obstacle_rate', 'out_of_bounds_rate', 'timeout_rate', 'navigation_time_mean',
        'path_length_mean', 'minimum_clearance_mean', 'intrusion_rate', 'decisions_per_second',
        'cases',
    } <= values.keys()  # fmt: skip
    assert (values['model'], values['scenario'], values['episodes']) == ('blind', 'hard', 5)
    low, high = values['success_interval']
    assert 0 <= low <= values['success_rate'] <= high <= 1
    assert {'case_index', 'outcome', 'time'} <= values['cases'][0].keys()


def test_a_policy_of_another_drive_is_refused():
    with pytest.raises(ConfigError, match='scenario.kinematics=differential'):
        evaluate(Differential(), HARD, 5)


def test_no_episodes_are_refused():
    with pytest.raises(ConfigError, match='must lie in'):
        evaluate(StraightLinePolicy(), HARD, 0)


@pytest.mark.parametrize('episodes', [0, -1, 1.5, 10**12])
def test_a_number_of_cases_that_is_none_is_refused(episodes):
    with pytest.raises(ConfigError, match='number of episodes'):
        evaluate(OrcaPolicy(), make_scenario('simple'), episodes)


def test_results_of_a_changed_world_say_what_was_changed():
    changed = dataclasses.replace(make_scenario('simple'), pedestrians=1)
    result = evaluate(StraightLinePolicy(), changed, 2)
    assert result.scenario == 'simple' and result.changes == {'pedestrians': 1}
    plain = evaluate(StraightLinePolicy(), make_scenario('simple'), 2)
    with pytest.raises(ConfigError, match='same cases'):
        compare([result, plain])
