"""Laws of training configurations."""

import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.mapping import to_yaml
from socialnav_core.config.reading import read_config, RECIPES
from socialnav_core.simulation import make_scenario


@pytest.mark.parametrize('name', sorted(path.stem for path in RECIPES.glob('*.yaml')))
def test_every_configuration_of_the_package_can_be_read_by_its_name(name):
    assert read_config(name).name == name


@pytest.mark.parametrize('name', ['sarl', 'sarl_curriculum'])
def test_saved_configuration_reads_as_it_was(name, tmp_path):
    config = read_config(name, {'scenario.time_limit': 35, 'training.worlds': 3})
    path = tmp_path / 'config.yaml'
    path.write_text(to_yaml(config))
    assert read_config(path) == config


def test_assignment_reaches_into_a_scenario_given_by_name():
    config = read_config('sarl', {'scenario.time_limit': 35, 'training.imitation.epochs': 1})
    assert config.scenario.time_limit == 35.0
    assert config.training.imitation.epochs == 1


def test_scenario_can_be_replaced_by_another_name():
    assert read_config('sarl', {'scenario': 'hard'}).scenario == make_scenario('hard')


def test_policy_takes_reward_and_motion_from_the_scenario():
    settings = {'scenario.reward.discomfort_distance': 0.4, 'scenario.kinematics': 'differential'}
    config = read_config('sarl', settings)
    assert config.policy.reward == config.scenario.reward
    assert config.policy.kinematics == 'differential'


def test_policy_that_contradicts_the_scenario_is_refused():
    with pytest.raises(ConfigError, match='policy.time_step is 0.1'):
        read_config('sarl', {'policy.time_step': 0.1})


def test_misspelt_setting_is_refused_with_the_nearest_one():
    with pytest.raises(ConfigError, match='learning_rate'):
        read_config('sarl', {'training.learning_rat': 0.1})


def test_unknown_configuration_is_refused_with_the_names_there_are():
    with pytest.raises(ConfigError, match='gat4sn'):
        read_config('nonsense')
