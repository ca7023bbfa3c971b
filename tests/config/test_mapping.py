"""Laws of settings from mappings, YAML and the command line."""

import pytest
import yaml

from socialnav_core.config import Config, ConfigError, OrcaConfig, PolicyConfig, Scenario
from socialnav_core.config.documents import read_yaml
from socialnav_core.config.mapping import (
    flatten,
    from_mapping,
    parse_assignments,
    replace,
    to_mapping,
    to_yaml,
)


def test_settings_survive_yaml():
    config = Config('run', Scenario('hard', bounds=float('inf')), PolicyConfig(heads=2), seed=3)
    assert from_mapping(Config, yaml.safe_load(to_yaml(config))) == config


def test_an_unknown_key_names_the_nearest_one():
    with pytest.raises(ConfigError, match="unknown setting 'orca.time_horizn'.*time_horizon"):
        replace(Scenario('hard'), {'orca.time_horizn': 4})
    with pytest.raises(ConfigError, match='did you mean heads'):
        from_mapping(PolicyConfig, {'haeds': 4})


@pytest.mark.parametrize(
    ('kind', 'values'),
    [
        (OrcaConfig, {'max_neighbors': 2.5}),
        (OrcaConfig, {'time_horizon': 'long'}),
        (OrcaConfig, {'time_horizon': True}),
        (Scenario, {'name': 'hard', 'renew_goals': 1}),
        (Scenario, {'name': 'hard', 'orca': 3}),
        (Scenario, {'pedestrians': 3}),
    ],
)
def test_a_value_of_the_wrong_type_is_refused(kind, values):
    with pytest.raises(ConfigError):
        from_mapping(kind, values)


@pytest.mark.parametrize(
    'assignment',
    [
        {'time_step': 0.0},
        {'obstacle_radius_min': 2.0},
        {'kinematics': 'omnidirectional'},
        {'pedestrians': -1},
        {'hardest_obstacle_ratio': 1.5},
    ],
)
def test_a_value_that_describes_no_world_is_refused(assignment):
    with pytest.raises(ConfigError):
        replace(Scenario('hard'), assignment)


def test_whole_numbers_and_scientific_notation_pass_for_floats():
    scenario = replace(Scenario('hard'), {'time_limit': 35, 'goal_tolerance': '2e-1'})
    assert (scenario.time_limit, scenario.goal_tolerance) == (35.0, 0.2)


def test_assignments_are_read_as_yaml():
    assert parse_assignments(['a.b=3', 'c=.inf', 'd=true', 'e=x=y']) == {
        'a.b': 3, 'c': float('inf'), 'd': True, 'e': 'x=y',
    }  # fmt: skip
    with pytest.raises(ConfigError, match='key=value'):
        parse_assignments(['a'])


def test_flattening_is_undone_by_replacing():
    scenario = Scenario('hard', orca=OrcaConfig(safety_space=0.3))
    assert replace(Scenario('simple'), flatten(to_mapping(scenario))) == scenario


@pytest.mark.parametrize('text', ['- a', 'a: [', ''])
def test_a_file_without_a_mapping_is_refused(tmp_path, text):
    path = tmp_path / 'config.yaml'
    path.write_text(text)
    with pytest.raises(ConfigError, match='config.yaml'):
        read_yaml(path)
