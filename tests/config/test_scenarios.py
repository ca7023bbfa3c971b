"""Laws of the named scenarios."""

import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.scenarios import (
    make_scenario,
    resolve_scenario,
    SCENARIOS,
    with_obstacle_radius,
)


def test_every_listed_scenario_exists():
    for name in SCENARIOS:
        scenario = make_scenario(name.replace('-R', '-1.5'))
        assert scenario.name == name.replace('-R', '-1.5')


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
