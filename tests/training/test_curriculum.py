"""Laws of the curriculum."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError, CurriculumConfig
from socialnav_core.simulation import make_scenario, Outcome, Simulator
from socialnav_core.training.curriculum import Curriculum

CONFIG = CurriculumConfig(enabled=True, window=10)


def play(curriculum, successes, failures):
    """Record episodes begun one after the other from the next that counts on."""
    outcome = np.array([Outcome.GOAL] * successes + [Outcome.TIMEOUT] * failures)
    cases = curriculum.window.next_case + np.arange(len(outcome))
    curriculum.window.record(cases, outcome, np.full(len(outcome), 10.0))


def test_first_level_has_obstacles_of_the_start_radius_only():
    scenario = Curriculum(CONFIG, next_case=0).scenario(make_scenario('curriculum-2.5'))
    assert scenario.obstacle_radius_min == scenario.obstacle_radius_max == 0.3


def test_level_keeps_all_else_of_the_scenario():
    full = make_scenario('packed-2.5')
    scenario = Curriculum(CONFIG, next_case=0).scenario(full)
    assert scenario.hardest_obstacle_ratio == full.hardest_obstacle_ratio == 0.2
    assert scenario.bounds == full.bounds and scenario.obstacles == full.obstacles


def test_level_rises_at_the_target_success_rate():
    curriculum = Curriculum(CONFIG, next_case=0)
    play(curriculum, successes=7, failures=3)
    assert curriculum.advance(next_case=10)
    assert curriculum.radius == pytest.approx(0.5)


def test_level_stays_below_the_target_success_rate():
    curriculum = Curriculum(CONFIG, next_case=0)
    play(curriculum, successes=6, failures=4)
    assert not curriculum.advance(next_case=10)
    assert curriculum.radius == 0.3


def test_level_stays_until_the_window_is_full():
    curriculum = Curriculum(CONFIG, next_case=0)
    play(curriculum, successes=9, failures=0)
    assert not curriculum.advance(next_case=9)


def test_only_episodes_begun_at_a_level_open_the_next():
    curriculum = Curriculum(CONFIG, next_case=0)
    play(curriculum, successes=10, failures=0)
    curriculum.advance(next_case=30)
    begun_before = np.arange(10, 30)
    goals = np.full(20, Outcome.GOAL)
    curriculum.window.record(begun_before, goals, np.full(20, 10.0))
    assert not curriculum.advance(next_case=30)


def test_radius_never_exceeds_the_last_level():
    curriculum = Curriculum(CONFIG, next_case=0)
    radii = [curriculum.radius]
    for _ in range(15):
        play(curriculum, successes=10, failures=0)
        curriculum.advance(curriculum.window.next_case)
        radii.append(curriculum.radius)
    assert radii[:12] == pytest.approx(0.3 + 0.2 * np.arange(12))
    assert radii[12:] == [2.5] * 4


def test_stored_curriculum_goes_on_like_the_original():
    original, copy = Curriculum(CONFIG, next_case=0), Curriculum(CONFIG, next_case=0)
    play(original, successes=10, failures=0)
    original.advance(next_case=10)
    play(original, successes=6, failures=0)
    copy.set_state(original.get_state())
    for curriculum in (original, copy):
        play(curriculum, successes=4, failures=0)
        assert curriculum.advance(next_case=20)
    assert copy.radius == original.radius == pytest.approx(0.7)


def at_level(level, scheduler, seed=0, **settings):
    """Return a curriculum that has reached a level."""
    config = dataclasses.replace(CONFIG, scheduler=scheduler, **settings)
    curriculum = Curriculum(config, next_case=0, seed=seed)
    curriculum.level = level
    return curriculum


def obstacle_radii(curriculum, worlds=200):
    """Return the obstacle radii of the first cases, the hardest first."""
    scenario = make_scenario('curriculum-2.5')
    simulator = Simulator(scenario, worlds)
    curriculum.apply(simulator, scenario)
    return simulator.reset(split='train').agents.radius[:, scenario.pedestrians :]


@pytest.mark.parametrize('scheduler', ['smooth', 'baby_step', 'one_pass'])
def test_first_level_is_the_same_for_all_schedulers(scheduler):
    assert (obstacle_radii(at_level(0, scheduler), worlds=5) == 0.3).all()


def test_smooth_levels_keep_small_obstacles_beside_the_hardest():
    radii = obstacle_radii(at_level(5, 'smooth'))
    np.testing.assert_allclose(radii[:, :2], 1.3)
    assert radii[:, 2:].min() < 0.35


def test_one_pass_throws_away_what_is_smaller_than_the_previous_level():
    radii = obstacle_radii(at_level(5, 'one_pass', largest_minimum=2.5))
    np.testing.assert_allclose(radii[:, :2], 1.3)
    assert 1.1 <= radii.min() < 1.15


def test_smallest_radius_stays_where_large_obstacles_find_room():
    radii = obstacle_radii(at_level(5, 'one_pass', largest_minimum=0.5))
    assert 0.5 <= radii.min() < 0.55
    packed = make_scenario('packed-2.5')
    last = at_level(11, 'one_pass')
    Simulator(last.scenario(packed), 4).reset(split='train')


def test_baby_steps_mix_all_opened_levels_evenly_within_a_batch():
    hardest = obstacle_radii(at_level(3, 'baby_step'), worlds=400)[:, 0]
    levels, counts = np.unique(hardest.round(6), return_counts=True)
    np.testing.assert_allclose(levels, [0.3, 0.5, 0.7, 0.9])
    np.testing.assert_allclose(counts / 400, 0.25, atol=0.07)


def test_obstacles_of_a_baby_step_are_those_of_its_level():
    curriculum = at_level(5, 'baby_step', largest_minimum=2.5)
    radii = obstacle_radii(curriculum)
    for case, row in enumerate(radii):
        largest = curriculum.radius_of(curriculum.bucket(case))
        assert largest - 0.2 - 1e-9 <= row.min() and row.max() == largest


def test_bucket_of_a_case_depends_on_case_level_and_seed_alone():
    first, second = at_level(4, 'baby_step'), at_level(4, 'baby_step')
    forwards = [first.bucket(case) for case in range(50)]
    assert [second.bucket(case) for case in reversed(range(50))] == forwards[::-1]
    other = at_level(4, 'baby_step', seed=1)
    assert [other.bucket(case) for case in range(50)] != forwards


def test_cases_have_their_buckets_whichever_world_runs_them():
    scenario, curriculum = make_scenario('curriculum-2.5'), at_level(4, 'baby_step')
    few, many = Simulator(scenario, 3), Simulator(scenario, 12)
    for simulator in (few, many):
        curriculum.apply(simulator, scenario)
    expected = many.reset(split='train').agents.radius
    radius = few.reset(split='train').agents.radius
    np.testing.assert_array_equal(radius, expected[:3])
    few.change_scenario(few.scenario)
    assert few.reset(split='train').agents.radius[:, 5].tolist() == [curriculum.radius] * 3


def test_unknown_scheduler_is_refused():
    with pytest.raises(ConfigError, match='smooth, baby_step, one_pass'):
        CurriculumConfig(scheduler='two_pass')
