"""Laws of the episodes that the page plays."""

import json

from made_report import SEED, SPLIT
import numpy as np
import pytest

from socialnav_core.evaluation import evaluate
from socialnav_core.policies import load_policy, OrcaPolicy
from socialnav_core.simulation import make_scenario
from socialnav_core.viewing import record
from socialnav_core.viewing.report.choice import EPISODES
from socialnav_core.viewing.report.contents import OUTCOME_NAMES
from socialnav_core.viewing.report.playback import PLAN_POINTS, playback, Watched

LARGEST_PAGE = 5e6  # bytes


@pytest.fixture(scope='module')
def valued():
    return playback(load_policy('gat4sn'), make_scenario('crowd20'), 0, 1, 'test', 'gat4sn')


@pytest.fixture(scope='module')
def planned():
    return playback(load_policy('search'), make_scenario('hard'), SEED, 0, SPLIT, 'search')


def test_an_episode_ends_as_in_the_evaluation():
    scenario = make_scenario('hard')
    records = evaluate(load_policy('gat4sn'), scenario, 3, SEED, SPLIT).records
    for case in range(3):
        played = playback(load_policy('gat4sn'), scenario, SEED, case, SPLIT, 'gat4sn')
        assert played['outcome'] == OUTCOME_NAMES[records.outcome[case]]
        assert played['times'][-1] == pytest.approx(records.time[case], abs=1e-3)
        assert played['closest'] == pytest.approx(records.minimum_clearance[case], abs=1e-3)


def test_positions_are_those_of_the_recording_to_a_centimetre():
    scenario = make_scenario('hard')
    played = playback(OrcaPolicy(), scenario, SEED, 1, SPLIT, 'orca')
    recording = record(OrcaPolicy(), scenario, SEED, 1, SPLIT)
    robot = np.reshape(played['robot'], (-1, 2)) / 100
    np.testing.assert_allclose(robot, recording.robot_path, atol=0.0051)
    people = np.reshape(played['people'], (len(recording.states), -1, 2)) / 100
    moving = ~recording.states[0].agents.static[0]
    np.testing.assert_allclose(people, recording.agent_paths[:, moving], atol=0.0051)
    assert len(played['obstacles']) == scenario.obstacles


def test_every_decision_of_a_value_network_has_attention_predictions_and_values(valued):
    decisions, people = len(valued['times']) - 1, 20
    assert [len(valued[name]) for name in ('attention', 'predicted', 'actions')] == 3 * [decisions]
    assert valued['plan'] == []
    for shares, paths, (places, values) in zip(
        valued['attention'], valued['predicted'], valued['actions'], strict=True
    ):
        assert len(shares) == people and sum(shares) == pytest.approx(100, abs=people / 2)
        assert len(paths) == 2 * 4 * people
        assert len(places) == 2 * len(values)
        assert max(values) == 100 and min(values) >= -1


def test_the_action_that_is_driven_is_one_of_the_best(valued):
    robot = np.reshape(valued['robot'], (-1, 2))
    moved = np.diff(robot, axis=0) / np.diff(valued['times'])[:, None]  # cm/s
    for (places, values), driven in zip(valued['actions'][:-1], moved[:-1], strict=True):
        best = np.reshape(places, (-1, 2))[np.array(values) >= 99]
        assert np.hypot(*(best - driven).T).min() < 6


def test_a_search_shows_its_plan_and_what_it_predicts(planned):
    decisions = len(planned['times']) - 1
    assert len(planned['plan']) == len(planned['predicted']) == decisions
    assert planned['actions'] == []
    assert all(2 <= len(plan) <= 2 * PLAN_POINTS for plan in planned['plan'])
    start, first = np.array(planned['robot'][:2]), np.array(planned['plan'][0][:2])
    assert np.hypot(*(first - start)) < 200


def test_to_be_watched_changes_no_decision():
    scenario = make_scenario('hard')
    watched, alone = Watched(load_policy('sarl')), load_policy('sarl')
    first, second = (record(policy, scenario, SEED, 2, SPLIT) for policy in (watched, alone))
    np.testing.assert_array_equal(first.robot_path, second.robot_path)


def test_people_who_are_not_there_have_no_place():
    scenario = make_scenario('crowd20_random')
    played = playback(OrcaPolicy(), scenario, SEED, 0, SPLIT, 'orca')
    assert len(played['sizes']) in (1, len(played['times']))
    for places in played['people']:
        assert len(places) == 2 * scenario.pedestrians


def test_as_many_long_episodes_as_a_page_plays_stay_below_its_size(valued):
    size = len(json.dumps(valued, separators=(',', ':'))) / len(valued['times'])
    longest = make_scenario('crowd20').time_limit / 0.25 + 1
    assert EPISODES * longest * size < LARGEST_PAGE
