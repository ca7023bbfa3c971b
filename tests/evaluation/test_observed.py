"""Laws of what a policy sees whose sensors are not perfect."""

import dataclasses

import numpy as np
import pytest

from socialnav_core import cli
from socialnav_core.config import ConfigError, ObservationConfig
from socialnav_core.evaluation import evaluate
from socialnav_core.evaluation.observed import Observer
from socialnav_core.policies import OrcaPolicy
from socialnav_core.simulation import make_scenario, Simulator

HARD = make_scenario('hard')
SIMULATOR = Simulator(HARD, 40)
STATE = SIMULATOR.reset(seed=3)
for _ in range(4):
    STATE = SIMULATOR.step(np.zeros((40, 2)))[0]
CASES, STEPS = np.arange(40), np.full(40, 4)
PEOPLE = slice(0, HARD.pedestrians)


def seen(cases=CASES, steps=STEPS, **settings):
    return Observer(ObservationConfig(**settings), HARD, 0).see(STATE, cases, steps)


def test_perfect_sensors_see_the_world_as_it_is():
    for name, array in seen().arrays().items():
        np.testing.assert_array_equal(array, STATE.arrays()[name], name)


def test_noise_is_as_large_as_asked_for_and_spares_obstacles():
    agents = seen(position_noise=0.05, velocity_noise=0.1).agents
    moved = agents.position - STATE.agents.position
    changed = agents.velocity - STATE.agents.velocity
    assert moved[:, PEOPLE].std() == pytest.approx(0.05, rel=0.15)
    assert changed[:, PEOPLE].std() == pytest.approx(0.1, rel=0.15)
    assert not moved[:, HARD.pedestrians :].any() and not changed[:, HARD.pedestrians :].any()


def test_a_share_of_the_people_is_missed_and_no_obstacle():
    valid = seen(missed=0.3).agents.valid
    assert 0.6 < valid[:, PEOPLE].mean() < 0.8
    assert valid[:, HARD.pedestrians :].all()


def test_nobody_is_seen_beyond_the_reach():
    agents = seen(reach=3.0).agents
    away = np.linalg.norm(STATE.agents.position - STATE.robot.position[:, None], axis=-1)
    near = away - STATE.agents.radius - 0.3 <= 3.0
    np.testing.assert_array_equal(agents.valid[:, PEOPLE], near[:, PEOPLE])


def test_a_delay_shows_people_where_they_were():
    earlier = STATE.agents.position - 0.1 * STATE.agents.velocity
    np.testing.assert_allclose(seen(delay=0.1).agents.position, earlier)


def test_what_is_drawn_depends_on_the_case_and_the_step_alone():
    one, other = seen(position_noise=0.1), seen(position_noise=0.1)
    np.testing.assert_array_equal(one.agents.position, other.agents.position)
    later = seen(steps=STEPS + 1, position_noise=0.1)
    assert (later.agents.position != one.agents.position)[:, PEOPLE].all()


def test_results_with_noise_do_not_depend_on_the_batch_size():
    noisy = ObservationConfig(position_noise=0.1, missed=0.2)
    alone, together = (
        evaluate(OrcaPolicy(), HARD, 12, batch_size=size, observation=noisy).records
        for size in (1, 8)
    )
    np.testing.assert_array_equal(alone.time, together.time)
    plain = evaluate(OrcaPolicy(), HARD, 12).records
    assert (plain.time != alone.time).any()


@pytest.mark.parametrize('settings', [{'missed': 1.0}, {'reach': 0.0}, {'position_noise': -1.0}])
def test_sensors_that_cannot_be_are_refused(settings):
    with pytest.raises(ConfigError, match='must lie in'):
        ObservationConfig(**settings)


def test_a_delay_of_more_than_a_step_is_refused():
    with pytest.raises(ConfigError, match='at most the time step'):
        seen(delay=HARD.time_step + 0.1)


def test_sensors_are_settings_of_the_command_line(capsys):
    words = ['--scenario', 'simple', '--set', 'observation.missed=0.5']
    assert cli.main(['evaluate', 'orca', *words, '--episodes', '4']) == 0
    assert cli.main(['render', 'orca', *words]) == 2
    assert 'render has no observation' in capsys.readouterr().err
    assert dataclasses.asdict(ObservationConfig())['missed'] == 0.0
