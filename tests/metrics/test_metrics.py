"""Figures of episodes whose outcomes are known."""

import json

from made_records import make_records
import numpy as np
import pytest

from socialnav_core.metrics import case_mappings, summarise
from socialnav_core.simulation import Outcome

EVERY_OUTCOME = [outcome for outcome in Outcome if outcome != Outcome.NONE]


def test_success_collision_and_time_out_add_up_to_one():
    summary = summarise(make_records(EVERY_OUTCOME + [Outcome.GOAL]))
    total = summary['success_rate'] + summary['collision_rate'] + summary['timeout_rate']
    assert total == pytest.approx(1.0)


def test_leaving_the_world_counts_as_a_collision_of_its_own_kind():
    summary = summarise(make_records([Outcome.OUT_OF_BOUNDS, Outcome.GOAL]))
    assert (summary['collision_rate'], summary['out_of_bounds_rate']) == (0.5, 0.5)
    assert summary['collision_pedestrian_rate'] == summary['collision_obstacle_rate'] == 0.0


def test_times_and_paths_are_averaged_over_successes():
    outcomes = [Outcome.GOAL, Outcome.TIMEOUT, Outcome.GOAL]
    summary = summarise(make_records(outcomes, time=[10, 25, 12], path_length=[8, 40, 9]))
    assert (summary['navigation_time_mean'], summary['path_length_mean']) == (11.0, 8.5)


def test_means_over_nothing_are_none():
    records = make_records([Outcome.TIMEOUT], minimum_clearance=[np.inf])
    summary = summarise(records)
    assert summary['navigation_time_mean'] is None
    assert summary['path_length_mean'] is None
    assert summary['minimum_clearance_mean'] is None


def test_episodes_without_agents_do_not_count_for_clearance():
    records = make_records([Outcome.GOAL] * 2, minimum_clearance=[0.3, np.inf])
    assert summarise(records)['minimum_clearance_mean'] == pytest.approx(0.3)


def test_the_intrusion_rate_is_a_share_of_steps_not_of_episodes():
    records = make_records([Outcome.GOAL] * 2, steps=[10, 30], intrusions=[10, 0])
    assert summarise(records)['intrusion_rate'] == pytest.approx(0.25)


def test_cases_are_valid_json_even_without_anybody_near():
    records = make_records(EVERY_OUTCOME, minimum_clearance=[np.inf] * len(EVERY_OUTCOME))
    cases = json.loads(json.dumps(case_mappings(records), allow_nan=False))
    assert [case['outcome'] for case in cases] == [
        'collision_pedestrian',
        'collision_obstacle',
        'out_of_bounds',
        'goal',
        'timeout',
    ]
    assert all(case['minimum_clearance'] is None for case in cases)
