"""A run is trained once, resumed where it stopped, and refused when it is another one."""

import pytest

from founding_report import runs
from founding_report.laboratory import merged, Request
from founding_report.measurements import Cases
from founding_report.rows import ROWS
from socialnav_core.config import ConfigError
from socialnav_core.config.mapping import parse_assignments
from socialnav_core.policies.value.checkpoint import load_checkpoint
from socialnav_core.training.resume import STATE_NAME

SARL = ROWS['sarl']


def test_a_run_with_a_saved_state_is_not_finished_and_is_resumed(finished_run):
    folder = finished_run(SARL, 0)
    assert runs.is_finished(folder)
    (folder / STATE_NAME).touch()
    assert not runs.is_finished(folder)
    assert '--resume' in runs.train_arguments(SARL, 0, folder, False, 'cpu')


def test_what_is_left_of_a_run_that_saved_nothing_is_removed(laboratory):
    folder = laboratory.run(SARL, 0)
    folder.mkdir(parents=True)
    (folder / '.weights.safetensors.123').touch()
    assert '--resume' not in runs.train_arguments(SARL, 0, folder, False, 'cpu')
    assert not folder.exists()


def test_a_run_with_other_settings_is_refused_by_naming_one(finished_run, laboratory):
    folder = finished_run(SARL, 0)
    runs.require_same_settings(SARL, 0, load_checkpoint(folder)[1], False, folder)
    with pytest.raises(ConfigError, match='seed = 0, not 1'):
        runs.require_same_settings(SARL, 1, load_checkpoint(folder)[1], False, folder)
    with pytest.raises(ConfigError, match='time_limit = 25.0, not 16.0; move it away'):
        laboratory = type(laboratory)(laboratory.folder, quick=True)
        laboratory.provide([Request(SARL, 0, ())])


def test_nothing_is_trained_where_that_is_forbidden(laboratory):
    with pytest.raises(ConfigError, match='is not trained; leave --no-train out'):
        laboratory.provide([Request(SARL, 0, ())], train=False)


@pytest.mark.parametrize('name', ROWS)
def test_settings_survive_the_command_line(name):
    assignments = ROWS[name].assignments(quick=True)
    assert parse_assignments(runs.assignment_texts(assignments)) == assignments


def test_requests_for_one_run_are_made_one_and_low_seeds_come_first():
    hard, simple = Cases('hard', 'oracle'), Cases('simple', 'oracle')
    requests = [Request(SARL, 1, (hard,)), Request(SARL, 0, (hard,)), Request(SARL, 1, (simple,))]
    assert [(each.seed, each.cases) for each in merged(requests)] == [
        (0, (hard,)),
        (1, (hard, simple)),
    ]
