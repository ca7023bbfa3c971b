"""The command does everything once, and a smoke run leaves the documentation alone."""

from pathlib import Path

import pytest

from founding_report.command import longest, NAMES
from founding_report.experiments import EXPERIMENTS
from socialnav_core.cli import main, USAGE

DOCUMENTATION = Path(__file__).parents[1] / 'results'


def contents(folder):
    """Return the files of a folder and when they were written."""
    return {path: path.stat().st_mtime_ns for path in folder.rglob('*') if path.is_file()}


def test_the_command_knows_every_table_and_figure():
    assert set(NAMES) == set(EXPERIMENTS)


def test_a_smoke_run_ships_nothing(capsys, tmp_path):
    arguments = ['reproduce', 'table3', '--quick', '--ship', '--out', str(tmp_path)]
    assert main(arguments) == USAGE
    assert 'learns nothing' in capsys.readouterr().err
    assert not contents(tmp_path)


def test_records_are_not_shipped_and_stand_for_no_training(capsys, tmp_path):
    before = contents(DOCUMENTATION)
    arguments = ['reproduce', 'table3', '--recorded', '--no-train', '--ship']
    assert main([*arguments, '--out', str(tmp_path)]) == USAGE
    assert 'is not trained' in capsys.readouterr().err
    assert contents(DOCUMENTATION) == before


def test_a_row_is_shipped_out_of_all_seeds_that_any_table_gives_it():
    entries = longest([EXPERIMENTS['figure1'], EXPERIMENTS['table2']])
    assert {entry.row.name: entry.seeds for entry in entries}['sarl'] == 10
    assert len({entry.row.name for entry in entries}) == len(entries)


@pytest.mark.slow
def test_a_smoke_run_trains_measures_and_writes_and_a_second_one_only_writes(capsys, tmp_path):
    before = contents(DOCUMENTATION)
    arguments = ['reproduce', 'table3', '--quick', '--out', str(tmp_path)]
    assert main(arguments) == 0
    first = capsys.readouterr()
    assert first.err.count('trained') == 2
    assert first.err.count('measured') == 4
    text = (tmp_path / 'quick' / 'results' / 'table3.md').read_text()
    assert 'nothing was learned' in text
    assert main(arguments) == 0
    assert not capsys.readouterr().err
    assert (tmp_path / 'quick' / 'results' / 'table3.md').read_text() == text
    assert contents(DOCUMENTATION) == before
