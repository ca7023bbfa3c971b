"""Pages hold the report's figures and ours, and keep the prose that people wrote."""

import json
import shutil

import pytest

from socialnav_core.reproduction import EXPERIMENTS, ship, write_results
from socialnav_core.reproduction.shipping import best_seed, card_cases, choice_cases
from socialnav_core.training.model_card import CARD_NAME

SEEDS = 2


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


def test_table_ii_has_a_column_for_each_network(laboratory, finished_run, measured, tmp_path):
    experiment = EXPERIMENTS['table2'].with_seeds(1)
    for entry in experiment.entries:
        folder = finished_run(entry.row, 0)
        for cases in entry.cases(laboratory):
            measured(folder, cases, ['goal', 'goal', 'timeout'])
    text = write_results(experiment, laboratory, tmp_path, 'command').read_text()
    assert '| Parameters | report | 66,051 | 72,401 | 78,751 | 85,101 | 96,502 |' in text
    assert '|  | ours | 66,051 | 72,401 | 78,751 | 85,101 | 96,502 |' in text
    assert '| Success, `hard` | report | 0.982 | 0.992 | 0.954 | 0.972 | 0.958 |' in text


def test_the_seed_is_chosen_on_validation_and_the_card_tells_of_the_test(
    laboratory, finished_run, measured, tmp_path
):
    (entry,) = (e for e in EXPERIMENTS['table3'].with_seeds(3).entries if 'gat' in e.row.name)
    solved, times = (2, 3, 3), (9.0, 12.0, 11.0)
    for seed in range(3):
        folder = finished_run(entry.row, seed)
        outcomes = ['goal'] * solved[seed] + ['timeout']
        measured(folder, choice_cases(entry), outcomes, times[seed])
        for cases in card_cases(entry):
            measured(folder, cases, ['goal'] * (seed + 1) + ['timeout'])
    assert best_seed(entry, laboratory) == 2
    (line,) = ship([entry], laboratory, tmp_path / 'models', tmp_path / 'records')
    folder = tmp_path / 'models' / 'gat4sn_simple10'
    assert 'seed 2 of 3; success crowd20 0.7500' in line
    assert json.loads((folder / 'metrics.json').read_text())['crowd20']['success_rate'] == 0.75
    assert '0.7500' in (folder / CARD_NAME).read_text()
    assert choice_cases(entry).split == 'validation'


def test_a_model_that_is_there_is_left_alone(laboratory, finished_run, measured, tmp_path):
    (entry, _) = EXPERIMENTS['table3'].with_seeds(1).entries
    measured(finished_run(entry.row, 0), choice_cases(entry), ['goal'])
    shutil.copytree(laboratory.run(entry.row, 0), tmp_path / 'models' / entry.row.name)
    assert not ship([entry], laboratory, tmp_path / 'models', tmp_path / 'records')
