"""Laws of the curriculum."""

import numpy as np
import pytest

from socialnav_core.config import CurriculumConfig
from socialnav_core.simulation import make_scenario, Outcome
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
