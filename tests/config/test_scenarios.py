"""Laws of the named scenarios."""

import dataclasses
from pathlib import Path

import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.mapping import to_yaml
from socialnav_core.config.scenarios import (
    changes_of,
    make_scenario,
    read_scenario,
    resolve_scenario,
    SCENARIOS,
    title_of,
    with_obstacle_radius,
)

RECORDED_PEOPLE = Path(__file__).parents[1] / 'data' / 'recorded_people.txt'


def test_every_listed_scenario_exists():
    for listed in SCENARIOS:
        name = listed.replace('-R', '-1.5').replace(':FILE', f':{RECORDED_PEOPLE}')
        assert make_scenario(name).name == name


def test_an_unknown_scenario_names_the_nearest():
    with pytest.raises(ConfigError, match='did you mean simple'):
        make_scenario('simpel')


@pytest.mark.parametrize('name', ['curriculum-0.2', 'packed-2.6', 'curriculum-', 'packed-x'])
def test_a_level_outside_of_the_curriculum_is_refused(name):
    with pytest.raises(ConfigError):
        make_scenario(name)


def test_the_curriculum_lives_in_the_larger_world():
    larger, packed = make_scenario('curriculum-2.5'), make_scenario('packed-2.5')
    assert (larger.bounds, larger.spawn_half_width, larger.minimum_travel) == (10.0, 7.5, 10.0)
    assert (packed.bounds, packed.spawn_half_width, packed.minimum_travel) == (7.5, 5.0, 7.5)


def test_settings_override_those_of_the_family():
    scenario = resolve_scenario({'name': 'hard', 'time_limit': 35, 'orca': {'time_horizon': 4}})
    assert (scenario.time_limit, scenario.orca.time_horizon) == (35.0, 4.0)
    assert scenario.obstacle_radius_max == make_scenario('hard').obstacle_radius_max


def test_an_unknown_setting_names_the_nearest():
    with pytest.raises(ConfigError, match='did you mean time_limit'):
        resolve_scenario({'name': 'hard', 'time_limt': 35})


def test_a_level_is_named_after_its_radius():
    assert with_obstacle_radius(make_scenario('packed-0.3'), 0.9) == make_scenario('packed-0.9')


def test_the_discount_of_a_step_is_per_metre_at_preferred_speed():
    assert make_scenario('simple').discount == pytest.approx(0.9**0.25)


def test_what_a_scenario_prints_can_be_read_again(tmp_path):
    path = tmp_path / 'world.yaml'
    for name in ('hard', 'circle', 'curriculum-1.5'):
        path.write_text(to_yaml(make_scenario(name)))
        assert read_scenario(path) == make_scenario(name)


def test_a_scenario_of_ones_own_has_its_name_and_says_everything(tmp_path):
    path = tmp_path / 'hall.yaml'
    text = to_yaml(make_scenario('hard')).replace('name: hard', 'name: hall')
    path.write_text(text)
    assert read_scenario(path) == dataclasses.replace(make_scenario('hard'), name='hall')
    path.write_text(text.replace('time_limit: 25.0\n', ''))
    with pytest.raises(ConfigError, match=r'hall.yaml, line 1: .*time_limit is missing'):
        read_scenario(path)


def test_a_mistake_in_a_file_is_told_with_its_line(tmp_path):
    path = tmp_path / 'world.yaml'
    path.write_text('name: hard\norca:\n  time_horizon: 0\n')
    with pytest.raises(ConfigError, match=r'world.yaml, line 3: scenario.orca.time_horizon'):
        read_scenario(path)


def test_what_was_changed_of_a_scenario_is_told():
    changed = resolve_scenario({'name': 'hard', 'orca': {'time_horizon': 4}, 'pedestrians': 3})
    assert changes_of(changed) == {'pedestrians': 3, 'orca.time_horizon': 4.0}
    assert (
        title_of('hard', changes_of(changed)) == 'hard with pedestrians=3, orca.time_horizon=4.0'
    )
    assert changes_of(make_scenario('packed-1.5')) == {}
    assert title_of('hard', {}) == 'hard'


@pytest.mark.parametrize('place', [(7.4, 0.0), (0.0, -8.0), (float('nan'), 0.0), (0.0,), 3, 'ab'])
def test_the_robot_can_be_put_where_it_has_room_only(place):
    with pytest.raises(ConfigError, match='robot_goal'):
        resolve_scenario({'name': 'hard', 'robot_goal': place})
