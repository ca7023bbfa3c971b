"""Pages hold the report's figures and ours, and keep the prose that people wrote."""

import json

import numpy as np
import pytest

from founding_report.experiments import EXPERIMENTS
from founding_report.markdown import number
from founding_report.writing import write_results

SEEDS = 2


@pytest.fixture
def with_measurements(laboratory, finished_run, measured):
    """Return a function that leaves the same measurement for each run of an experiment."""

    def make(name, seeds=1):
        experiment = EXPERIMENTS[name].with_seeds(seeds)
        for entry in experiment.entries:
            for seed in range(seeds):
                folder = finished_run(entry.row, seed)
                for cases in entry.cases(laboratory):
                    measured(folder, cases, ['goal', 'goal', 'timeout'])
        return experiment

    return make


@pytest.fixture
def table3(laboratory, finished_run, measured):
    """Return table III, for which all was measured: GAT4SN solves 3 of 4 cases, SARL 2."""
    experiment = EXPERIMENTS['table3'].with_seeds(SEEDS)
    for entry, solved in zip(experiment.entries, (3, 2), strict=True):
        for seed in range(SEEDS):
            folder = finished_run(entry.row, seed)
            for cases in entry.cases(laboratory):
                measured(folder, cases, ['goal'] * solved + ['timeout'] * (4 - solved))
    return experiment


def test_a_page_has_the_reports_figures_beside_ours(table3, laboratory, tmp_path):
    text = write_results(table3, laboratory, tmp_path, 'socialnav reproduce table3').read_text()
    assert '| GAT4SN, 4 heads | `crowd20` | 0.972 | 0.750 | 0.750 | 0.022 |' in text
    assert '0.750: missed by 0.222' in text
    assert 'socialnav reproduce table3' in text
    assert '| 2.0 |' in text  # minutes


@pytest.mark.parametrize(
    ('value', 'figure', 'text'),
    [(13.645, 'time', '13.65'), (0.9735, 'success', '0.974'), (1e-9, 'success', '0.000'),
     (np.float64(1), 'success', '1.000'), (None, 'time', '-')],
)  # fmt: skip
def test_numbers_are_rounded_as_people_do_it(value, figure, text):
    assert number(value, figure) == text


def test_the_figures_are_written_as_json_too(table3, laboratory, tmp_path):
    write_results(table3, laboratory, tmp_path, 'command')
    values = json.loads((tmp_path / 'table3.json').read_text())
    first = values['results'][0]
    assert first['means']['success']['mean'] == 0.75
    assert first['report']['success'] == 0.972
    assert [seed['training_seed'] for seed in first['seeds']] == [0, 1]
    assert values['training'][0]['seconds'] == 120.0


def test_writing_again_keeps_the_notes(table3, laboratory, tmp_path):
    notes = tmp_path / 'notes' / 'table3.md'
    notes.parent.mkdir()
    notes.write_text('Twenty people are many.\n')
    pages = [write_results(table3, laboratory, tmp_path, 'command').read_text() for _ in range(2)]
    assert pages[0] == pages[1]
    assert '## Interpretation\n\nTwenty people are many.' in pages[0]


def test_table_ii_has_a_column_for_each_network(laboratory, with_measurements, tmp_path):
    experiment = with_measurements('table2')
    text = write_results(experiment, laboratory, tmp_path, 'command').read_text()
    assert '| Parameters | report | 66,051 | 72,401 | 78,751 | 85,101 | 96,502 |' in text
    assert '|  | ours | 66,051 | 72,401 | 78,751 | 85,101 | 96,502 |' in text
    assert '| Success, `hard` | report | 0.982 | 0.992 | 0.954 | 0.972 | 0.958 |' in text


def test_what_the_report_has_no_figures_for_is_compared_among_ours_alone(
    laboratory, with_measurements, tmp_path
):
    experiment = with_measurements('schedulers')
    text = write_results(experiment, laboratory, tmp_path, 'command').read_text()
    assert 'Verdicts' not in text and "The report's figures" not in text
    assert '| SARL with baby steps, packed | `packed-2.5` | oracle | 1 | 0.667' in text
