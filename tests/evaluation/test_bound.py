"""Laws of the bound: what it finds can be driven, and nothing that is known beats it by much."""

import dataclasses

import numpy as np
import pytest

from socialnav_core import cli
from socialnav_core.config import BoundConfig, ConfigError
from socialnav_core.evaluation import evaluate, find_bounds, known_bounds, with_bounds
from socialnav_core.evaluation.bound import bounds_of, find_path, moves_of, path_time
from socialnav_core.evaluation.futures import record_futures, steps_until_limit
from socialnav_core.evaluation.witness import witness_of, WitnessPolicy
from socialnav_core.metrics import METRICS
from socialnav_core.policies import StraightLinePolicy
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.viewing import record

CASES = np.arange(4)
EMPTY = dataclasses.replace(make_scenario('hard'), pedestrians=0, obstacles=0)


@pytest.mark.parametrize('crowd', ['orca', 'non_reactive'])
def test_recorded_people_do_what_they_do_in_the_simulator(crowd):
    scenario = dataclasses.replace(make_scenario('hard'), crowd=crowd)
    futures = record_futures(scenario, np.array([3, 5]), 2, 'test')
    simulator = Simulator(scenario, 2, autoreset='disabled')
    state = simulator.reset(seed=2, cases=[3, 5])
    for step in range(40):
        if not simulator.active.all():
            break
        np.testing.assert_array_equal(futures.position[:, step], state.agents.position)
        state = simulator.step(np.zeros((2, 2)))[0]
        np.testing.assert_array_equal(futures.velocity[:, step], state.agents.velocity)
    assert step > 5


@pytest.mark.parametrize('name', ['hard', 'crowd20', 'packed-2.5'])
@pytest.mark.parametrize('gap', [0.0, 0.2])
def test_a_path_that_is_found_arrives_in_the_simulator_in_just_that_time(name, gap):
    scenario = make_scenario(name)
    futures = record_futures(scenario, CASES, 1, 'test')
    paths = [find_path(futures, case, gap) for case in CASES]
    assert any(path is not None for path in paths)
    for case, path in enumerate(paths):
        if path is None:
            continue
        driven = record(WitnessPolicy(path, scenario.time_step), scenario, 1, case)
        assert driven.outcome == 'goal'
        assert driven.times[-1] == pytest.approx(path_time(path, scenario))
        steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
        assert (steps <= scenario.time_step * scenario.robot_preferred_speed + 1e-9).all()


def test_a_comfortable_path_keeps_its_distance_at_every_moment():
    scenario = make_scenario('crowd20')
    policy = witness_of(scenario, 0)
    records = evaluate(policy, scenario, 1).records
    assert records.success.all()
    assert np.nanmin(records.pedestrian_clearance) >= 0.2


def test_nobody_is_faster_than_the_straight_line():
    bounds = find_bounds(EMPTY, CASES)
    records = evaluate(StraightLinePolicy(), EMPTY, len(CASES)).records
    least = np.ceil(records.straight_path / EMPTY.time_step) * EMPTY.time_step
    np.testing.assert_allclose(bounds.fastest, least)
    np.testing.assert_array_equal(bounds.comfortable, bounds.fastest)


def test_keeping_a_distance_takes_no_less_time():
    bounds = find_bounds(make_scenario('crowd20'), CASES)
    assert (bounds.comfortable >= bounds.fastest - 0.25).all()


def test_a_case_that_cannot_be_done_in_time_has_no_bound():
    hopeless = dataclasses.replace(EMPTY, time_limit=2.0)
    bounds = find_bounds(hopeless, CASES)
    assert np.isinf(bounds.fastest).all()
    with pytest.raises(ConfigError, match='no path'):
        witness_of(hopeless, 0)


def test_arriving_in_the_very_last_step_counts():
    time = find_bounds(EMPTY, CASES[:1]).fastest[0]
    just = dataclasses.replace(EMPTY, time_limit=time)
    assert steps_until_limit(just) == round(time / EMPTY.time_step)
    assert find_bounds(just, CASES[:1]).fastest[0] == time
    tighter = dataclasses.replace(EMPTY, time_limit=time - EMPTY.time_step)
    assert np.isinf(find_bounds(tighter, CASES[:1]).fastest[0])


def test_a_coarser_search_finds_no_much_faster_paths():
    futures = record_futures(make_scenario('packed-2.5'), CASES, 0, 'test')
    fine = bounds_of(futures, BoundConfig())
    coarse = bounds_of(futures, BoundConfig(headings=16, cell=0.125))
    assert (coarse.fastest >= fine.fastest - 0.25).all()


def test_no_move_is_longer_than_a_step():
    assert np.linalg.norm(moves_of(BoundConfig()), axis=1).max() == pytest.approx(1.0)


def test_people_who_see_the_robot_have_no_future_of_their_own():
    seen = dataclasses.replace(EMPTY, robot_visible=True)
    with pytest.raises(ConfigError, match='robot_visible=false'):
        find_bounds(seen, CASES)


def test_a_bound_is_computed_once(monkeypatch, tmp_path):
    monkeypatch.setattr(known_bounds, 'cache_folder', lambda: tmp_path)
    monkeypatch.setattr(known_bounds, 'cache_is_writable', lambda: True)
    scenario = make_scenario('hard')
    first = find_bounds(scenario, CASES)
    monkeypatch.setattr(known_bounds, 'bounds_of', None)
    again = find_bounds(scenario, CASES[::-1])
    np.testing.assert_array_equal(again.fastest[::-1], first.fastest)
    with pytest.raises(TypeError):
        find_bounds(scenario, np.array([9]))  # not known yet


def test_what_cannot_be_solved_does_not_count_against_a_policy():
    scenario = dataclasses.replace(EMPTY, time_limit=9.0)
    result = with_bounds(evaluate(StraightLinePolicy(), scenario, 40), scenario)
    figure = {name: METRICS[name].figure(result.records) for name in METRICS}
    assert 0.0 < figure['success_rate'] < 1.0
    assert figure['solvable_rate'] == pytest.approx(figure['success_rate'], abs=0.2)
    assert figure['solvable_success_rate'] >= figure['success_rate'] / figure['solvable_rate']
    low, high = result.interval('solvable_success_rate')
    assert low <= figure['solvable_success_rate'] <= high


def test_the_bound_is_shown_where_it_is_asked_for(capsys):
    words = ['--scenario', 'hard', '--episodes', '4']
    assert cli.main(['evaluate', 'orca', *words, '--bound']) == 0
    assert 'time over the bound' in capsys.readouterr().out
    assert cli.main(['compare', 'orca', 'straight_line', *words, '--bound']) == 0
    assert 'over comfortable' in capsys.readouterr().out
    assert cli.main(['bound', *words]) == 0
    assert 'keeping 0.2 m of people  4 of 4' in capsys.readouterr().out
