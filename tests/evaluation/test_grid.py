"""Laws of the grid of worlds: what its cells are, that nothing is dropped, that it goes on."""

import dataclasses
import json
import math

import numpy as np
from PIL import Image
import pytest

from socialnav_core import cli
from socialnav_core.config import ConfigError, ObservationConfig, SearchConfig
from socialnav_core.config.grid import at_distance, AXES, grid_from, Table, world_of
from socialnav_core.config.reading import read_grid_config
from socialnav_core.evaluation import grid
from socialnav_core.evaluation.grid import cells_of, run_cell, run_grid
from socialnav_core.evaluation.grid_report import table_rows, UNPACKED
from socialnav_core.policies import load_policy
from socialnav_core.simulation import make_scenario, PackingError, Simulator

FULL, QUICK = read_grid_config('full'), read_grid_config('quick')
HUGE = {'obstacle_radius_min': 20, 'obstacle_radius_max': 21}
VALUES = {'scenario': 'hard', 'episodes': 4, 'seed': 0, 'split': 'test',
          'tables': {'crowd': {'people': [0], 'obstacles': [0, 1], 'world': HUGE}}}  # fmt: skip


def test_the_full_grid_covers_every_axis():
    assert {axis for table in FULL.tables for axis in table.axes} == set(AXES)
    assert len(list(cells_of(FULL))) == 63


def test_every_cell_of_the_full_grid_has_a_world_of_its_own():
    worlds = [world_of(*cell) for cell in cells_of(FULL)]
    assert len({dataclasses.replace(world, name='same') for world in worlds}) >= len(worlds) - 7
    assert all(world.name for world in worlds)


@pytest.mark.parametrize('distance', [2.0, 10.0, 50.0])
def test_goals_are_as_far_away_as_the_axis_says(distance):
    world = at_distance(make_scenario('hard'), distance)
    robot = Simulator(world, 50).reset().robot
    travel = np.abs(robot.goal - robot.position).max(axis=1)
    assert (travel > 0.75 * distance).all() and (travel <= 1.25 * distance).all()
    assert (np.abs(robot.position).max(axis=1) + robot.radius < world.bounds).all()
    assert world.time_limit >= 2.0 * distance


def test_a_slow_robot_has_more_time_and_a_world_without_walls_has_none():
    hard = make_scenario('hard')
    assert AXES['robot_speed'](hard, 0.5).time_limit == 2 * hard.time_limit
    assert AXES['robot_speed'](hard, 1.5).time_limit == hard.time_limit
    assert AXES['walls'](hard, False).bounds == math.inf
    assert AXES['walls'](hard, True) == hard


def test_a_policy_is_told_what_it_shares_with_its_world(monkeypatch):
    told = {}
    asked = grid.load_policy

    def load(model, **settings):
        told.update(settings)
        return asked(model, **settings)

    monkeypatch.setattr(grid, 'load_policy', load)
    monkeypatch.setattr(grid, 'evaluate', None)
    world = dataclasses.replace(make_scenario('hard'), time_step=0.1)
    table = Table('a', world, {'tolerance': (0.15,)})
    with pytest.raises(TypeError):
        run_cell('search', table, {'tolerance': 0.15}, QUICK, False)
    assert told == {'time_step': 0.1, 'goal_tolerance': 0.15}


def test_a_world_that_cannot_be_packed_is_said_and_not_dropped():
    config = grid_from(VALUES, 'crowded')
    cells = run_grid('straight_line', config, False, [], lambda cells: None)
    assert 'no layout found' in cells[1]['unpacked']
    rows = table_rows(config.tables[0], cells)
    assert rows[2][:3] == ('0', '1', UNPACKED)
    assert cells[0]['success_rate'] == 1.0


def test_what_was_run_before_is_not_run_again():
    config = grid_from(VALUES | {'tables': {'size': {'robot_radius': [0.2, 0.3]}}}, 'small')
    kept = []
    whole = run_grid('straight_line', config, False, [], lambda cells: kept.append(len(cells)))
    assert kept == [1, 2]
    known = [whole[0] | {'marked': True}]
    again = run_grid('straight_line', config, False, known, lambda cells: kept.append(len(cells)))
    assert kept == [1, 2, 2]
    assert again[0]['marked'] and again[1] == whole[1]


@pytest.mark.parametrize(
    ('change', 'message'),
    [
        ({'episode': 3}, 'did you mean episodes'),
        ({'tables': {'a': {'peple': [1]}}}, 'did you mean people'),
        ({'tables': {'a': {'people': 3}}}, 'must be a list'),
        ({'tables': {'a': {}}}, 'one axis or two'),
        ({'episodes': 0}, 'at least 1'),
        ({'split': 'exam'}, 'split must be one of'),
    ],
)
def test_a_mistake_in_the_file_of_a_grid_is_named(change, message):
    with pytest.raises(ConfigError, match=message):
        grid_from(VALUES | change, 'wrong')


def test_a_value_that_no_world_can_have_is_named():
    table = Table('a', make_scenario('hard'), {'tolerance': ('wide',)})
    with pytest.raises(ConfigError, match='goal_tolerance'):
        world_of(table, {'tolerance': 'wide'})


def test_a_variant_changes_the_world_the_policy_and_what_it_sees(monkeypatch):
    seen = {}
    changed = {
        'scenario.pedestrian_speed': 0.5, 'policy.contact': 7.0, 'observation.missed': 0.25,
    }  # fmt: skip
    table = {'variant': {'plain': {}, 'other': changed}}
    config = grid_from(VALUES | {'tables': {'a': table}}, 'variants')

    def evaluate(policy, scenario, *_, observation, **__):
        seen[scenario.name] = (scenario.pedestrian_speed, policy.settings.contact, observation)
        raise PackingError('seen enough')

    monkeypatch.setattr(grid, 'evaluate', evaluate)
    run_grid('search', config, False, [], lambda cells: None)
    assert seen['plain'] == (1.0, SearchConfig().contact, None)
    assert seen['other'] == (0.5, 7.0, ObservationConfig(missed=0.25))


@pytest.mark.parametrize('settings, message', [
    ({'crowd': 'orca'}, 'unknown'),
    ({'scenario.crowds': 'orca'}, 'crowd'),
    ({'observation.missing': 0.1}, 'missed'),
    ('noise', 'must be a mapping'),
])  # fmt: skip
def test_a_mistake_in_a_variant_is_named(settings, message):
    with pytest.raises(ConfigError, match=message):
        grid_from(VALUES | {'tables': {'a': {'variant': {'it': settings}}}}, 'wrong')


@pytest.mark.parametrize('name', ['robustness', 'ablation', 'worlds'])
def test_the_variants_that_come_along_are_of_worlds_and_policies_that_exist(name):
    config = read_grid_config(name)
    for table, values in cells_of(config):
        world_of(table, values)
        load_policy('socialnav', **table.changes(values, 'policy'))


def test_the_command_writes_a_file_a_policy_a_picture_and_a_page(tmp_path, capsys):
    words = ['grid', 'straight_line', 'orca', '--quick', '--bound', '--out', str(tmp_path)]
    more = ['--picture', str(tmp_path / 'map.png'), '--markdown', str(tmp_path / 'tables.md')]
    assert cli.main([*words, *more]) == 0
    first = capsys.readouterr().out
    assert 'over bound' in first and 'orca: 4 cases of test a world, seed 0' in first
    assert len(json.loads((tmp_path / 'orca.json').read_text())['cells']) == 6
    assert Image.open(tmp_path / 'map.png').size[0] > 300
    assert '| people | obstacles | success |' in (tmp_path / 'tables.md').read_text()
    before = (tmp_path / 'orca.json').stat().st_mtime_ns
    assert cli.main(words) == 0
    assert capsys.readouterr().out == first
    assert (tmp_path / 'orca.json').stat().st_mtime_ns == before
    assert cli.main([*words, '--episodes', '5']) == 2
    assert 'of another grid' in capsys.readouterr().err
