"""A record stands for a run that is not here, for its measurements but not for its weights."""

import shutil

import pytest

from founding_report.experiments import Entry, EXPERIMENTS
from founding_report.laboratory import Laboratory, record_path, Request
from founding_report.measurements import Cases
from founding_report.rows import ROWS
from founding_report.writing import write_results
from socialnav_core.config import ConfigError
from socialnav_core.policies.value.checkpoint import build_network, save_weights

SARL = ROWS['sarl']
HARD = Cases('hard', 'oracle')


@pytest.fixture
def elsewhere(laboratory, finished_run, measured, tmp_path):
    """Return a laboratory without runs that has the record of one: SARL, seed 0, in `hard`."""
    folder = finished_run(SARL, 0)
    measured(folder, HARD, ['goal', 'timeout', 'collision_pedestrian'])
    laboratory.publish(Request(SARL, 0, (HARD,)), tmp_path / 'records')
    return Laboratory(tmp_path / 'other', announce=lambda line: None, records=tmp_path / 'records')


def test_a_record_has_the_measurements_and_the_training_of_its_run(elsewhere, laboratory):
    ours = elsewhere.measurement(SARL, 0, HARD)
    theirs = laboratory.measurement(SARL, 0, HARD)
    assert ours.outcome.tolist() == theirs.outcome.tolist()
    assert ours.time.tolist() == theirs.time.tolist()
    assert ours.summary == theirs.summary
    assert elsewhere.training(SARL, 0) == laboratory.training(SARL, 0)


def test_nothing_is_trained_that_is_recorded(elsewhere):
    elsewhere.provide([Request(SARL, 0, (HARD,))], train=False)


@pytest.mark.parametrize(
    'request_', [Request(SARL, 1, (HARD,)), Request(SARL, 0, (Cases('simple', 'oracle'),))]
)
def test_other_seeds_and_cases_are_still_to_be_trained(elsewhere, request_):
    with pytest.raises(ConfigError, match='is not trained'):
        elsewhere.provide([request_], train=False)


def test_a_run_that_is_here_comes_before_its_record(elsewhere, laboratory, finished_run, measured):
    here = Laboratory(laboratory.folder, records=elsewhere.records)
    finished_run(SARL, 0)  # fresh weights
    measured(here.run(SARL, 0), HARD, ['goal'] * 3)
    assert here.measurement(SARL, 0, HARD).success.all()


def test_a_record_of_other_settings_is_refused_by_naming_one(elsewhere):
    path = record_path(elsewhere.records, SARL, 0)
    path.write_text(path.read_text().replace('batch_size: 512', 'batch_size: 8'))
    with pytest.raises(ConfigError, match='training.batch_size = 8, not 512; move it away'):
        elsewhere.measurement(SARL, 0, HARD)


@pytest.mark.parametrize('text', ['', '{}', '[]', '{"config": "a: 1", "training": {}}'])
def test_what_is_no_record_is_refused(elsewhere, text):
    record_path(elsewhere.records, SARL, 0).write_text(text)
    with pytest.raises(ConfigError, match='holds no record of a run'):
        elsewhere.measurement(SARL, 0, HARD)


def test_a_record_grows_with_what_is_measured_later(elsewhere, laboratory, measured):
    simple = Cases('simple', 'oracle')
    measured(laboratory.run(SARL, 0), simple, ['goal'])
    laboratory.publish(Request(SARL, 0, (simple,)), elsewhere.records)
    elsewhere.provide([Request(SARL, 0, (simple, HARD))], train=False)


def test_a_page_made_of_records_is_the_page_made_of_runs(
    laboratory, finished_run, measured, tmp_path
):
    experiment = EXPERIMENTS['table3'].with_seeds(1)
    for entry in experiment.entries:
        folder = finished_run(entry.row, 0)
        for cases in entry.cases(laboratory):
            measured(folder, cases, ['goal', 'goal', 'timeout'])
    text = write_results(experiment, laboratory, tmp_path / 'pages', 'command').read_text()
    shutil.rmtree(laboratory.folder)
    again = Laboratory(laboratory.folder, records=tmp_path / 'pages' / 'records')
    assert write_results(experiment, again, tmp_path / 'pages', 'command').read_text() == text


def test_weights_as_trained_are_measured_in_the_run_of_the_folded_ones(
    laboratory, finished_run, measured
):
    row = ROWS['sarl_unfolded']
    (cases, _) = Entry(row, 1).cases(laboratory)
    run = finished_run(SARL, 0)
    assert laboratory.run(row, 0) == run
    assert cases.checkpoint(run) != run
    config = SARL.resolved(0, quick=False)
    save_weights(cases.checkpoint(run), build_network(config.policy), config)
    measured(run, cases, ['timeout'])
    measured(run, HARD, ['goal'])
    assert laboratory.measurement(row, 0, cases).timeout.all()
    assert laboratory.measurement(SARL, 0, HARD).success.all()
