"""A recording is the episode that an evaluation of the same case runs."""

import numpy as np
import pytest

from socialnav_core.evaluation import evaluate
from socialnav_core.policies import OrcaPolicy
from socialnav_core.simulation import make_scenario, Outcome
from socialnav_core.viewing import record
from socialnav_core.viewing.recording import clearance, state_at

HARD = make_scenario('hard')


@pytest.fixture(scope='module')
def recording():
    return record(OrcaPolicy(), HARD, seed=7, case_index=2, name='orca')


def test_a_recording_ends_as_the_evaluation_of_its_case(recording):
    records = evaluate(OrcaPolicy(), HARD, 3, 7).records
    assert recording.outcome == Outcome(records.outcome[2]).name.lower()
    assert recording.times[-1] == records.time[2]
    assert recording.minimum_clearance == pytest.approx(records.minimum_clearance[2])


def test_a_recording_holds_the_start_and_every_step(recording):
    assert recording.times[0] == 0.0
    np.testing.assert_allclose(np.diff(recording.times), HARD.time_step)


def test_the_least_clearance_is_at_most_that_of_any_state(recording):
    assert recording.minimum_clearance <= min(map(clearance, recording.states)) + 1e-9


def test_a_state_between_two_others_lies_half_way(recording):
    between = state_at(recording, 0.375)
    expected = (recording.robot_path[1] + recording.robot_path[2]) / 2
    np.testing.assert_allclose(between.robot.position[0], expected)
    assert between.time[0] == 0.375


@pytest.mark.parametrize('moment', [0, 3, -1])
def test_recorded_moments_give_the_recorded_positions(recording, moment):
    state = state_at(recording, recording.times[moment])
    np.testing.assert_allclose(state.robot.position[0], recording.robot_path[moment])
    np.testing.assert_allclose(state.agents.position[0], recording.agent_paths[moment])
