"""A model in models/ is the best seed, complete, and never a mixture of two runs."""

import json

import pytest

from founding_report import shipping
from founding_report.experiments import Entry, EXPERIMENTS
from founding_report.measurements import Cases
from founding_report.rows import ROWS
from founding_report.shipping import best_seed, card_cases, choice_cases, ship
from socialnav_core.config import ConfigError
from socialnav_core.policies.value.checkpoint import checkpoint_digest, WEIGHTS
from socialnav_core.training.model_card import CARD_NAME, METRICS_NAME

ENTRY = Entry(ROWS['gat4sn_simple10'], 1)
FEW = 4


@pytest.fixture(autouse=True)
def small_cards(monkeypatch):
    """Let cards have few cases."""
    monkeypatch.setattr(shipping, 'CARD_EPISODES', FEW)


@pytest.fixture
def shipped(laboratory, tmp_path):
    """Return a function that ships a row; it returns the lines about it."""

    def do(entry=ENTRY, **options):
        return ship([entry], laboratory, tmp_path / 'models', tmp_path / 'records', **options)

    return do


@pytest.fixture
def trained(finished_run, measured):
    """Return a function that leaves a run of a row with all that shipping measures."""

    def make(entry=ENTRY, solved=FEW):
        folder = finished_run(entry.row, 0)
        for cases in (choice_cases(entry), *card_cases(entry)):
            measured(folder, cases, ['goal'] * solved + ['timeout'] * (FEW - solved))
        return folder

    return make


def metrics(folder):
    """Return the results of a model."""
    return json.loads((folder / METRICS_NAME).read_text())


def test_the_seed_is_chosen_on_validation_and_the_card_tells_of_the_test(
    laboratory, finished_run, measured, shipped, tmp_path
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
    (line,) = shipped(entry)
    folder = tmp_path / 'models' / 'gat4sn_simple10'
    assert 'seed 2 of 3; success crowd20 0.7500' in line
    assert metrics(folder)['crowd20']['success_rate'] == 0.75
    assert '0.7500' in (folder / CARD_NAME).read_text()
    assert choice_cases(entry).split == 'validation'


def test_a_model_that_is_there_is_left_alone(trained, shipped):
    trained()
    assert len(shipped()) == 1
    assert not shipped()


def test_a_card_of_fewer_cases_is_renewed_and_keeps_what_else_was_measured(
    trained, shipped, tmp_path
):
    trained()
    shipped()
    folder = tmp_path / 'models' / ENTRY.row.name
    old = metrics(folder)['crowd20']
    values = {
        'crowd20': old | {'episodes': FEW - 1},
        'hard': old | {'scenario': 'hard', 'episodes': 7},
    }
    (folder / METRICS_NAME).write_text(json.dumps(values))
    assert len(shipped()) == 1
    assert {name: each['episodes'] for name, each in metrics(folder).items()} == {
        'crowd20': FEW,
        'hard': 7,
    }


def test_other_weights_lose_all_results_of_those_before(trained, shipped, tmp_path):
    trained()
    shipped()
    folder = tmp_path / 'models' / ENTRY.row.name
    values = metrics(folder)
    (folder / METRICS_NAME).write_text(json.dumps(values | {'hard': values['crowd20']}))
    run = trained(solved=1)
    assert len(shipped()) == 1
    assert checkpoint_digest(folder) == checkpoint_digest(run)
    assert list(metrics(folder)) == ['crowd20']


@pytest.mark.parametrize('killed_at', range(5))
def test_a_copy_that_was_killed_leaves_no_mixture_and_is_made_again(
    trained, shipped, tmp_path, monkeypatch, killed_at
):
    trained()
    shipped()
    folder = tmp_path / 'models' / ENTRY.row.name
    run = trained(solved=1)
    kill_at_write(monkeypatch, killed_at)
    with pytest.raises(KeyboardInterrupt):
        shipped()
    monkeypatch.undo()
    monkeypatch.setattr(shipping, 'CARD_EPISODES', FEW)
    if (folder / WEIGHTS).exists():
        assert checkpoint_digest(folder) == checkpoint_digest(run)
        assert metrics(folder)['crowd20']['success_rate'] == 0.25
    shipped()
    assert checkpoint_digest(folder) == checkpoint_digest(run)
    assert '0.2500' in (folder / CARD_NAME).read_text()


def kill_at_write(monkeypatch, number):
    """Let the copy be interrupted at one of its writes: four files and then the card."""
    writes = iter(range(5))
    write, card = shipping.atomic_write, shipping.write_model_card

    def stop_or(what, *arguments):
        if next(writes) == number:
            raise KeyboardInterrupt
        what(*arguments)

    monkeypatch.setattr(shipping, 'atomic_write', lambda *given: stop_or(write, *given))
    monkeypatch.setattr(shipping, 'write_model_card', lambda *given: stop_or(card, *given))


def test_the_cards_of_sarl_and_gat4sn_have_the_oracle_too(trained, shipped, tmp_path):
    entry = Entry(ROWS['sarl'], 1)
    trained(entry)
    shipped(entry)
    keys = ['hard', 'hard+oracle', 'simple', 'simple+oracle']
    assert list(metrics(tmp_path / 'models' / 'sarl')) == keys
    assert [c.lookahead for c in card_cases(ENTRY)] == ['constant_velocity']


def test_a_result_counts_by_the_name_of_the_scenario_and_with_more_cases():
    result = {'scenario': 'curriculum-2', 'lookahead': 'oracle', 'split': 'test', 'seed': 0,
              'screening': False, 'episodes': 6}  # fmt: skip
    cases = Cases('curriculum-2.0', 'oracle', episodes=5)
    assert shipping.is_among(cases, [result])
    for change in ({'episodes': 4}, {'split': 'validation'}, {'screening': True}):
        assert not shipping.is_among(cases, [result | change])


def test_nothing_is_trained_for_shipping_where_that_is_forbidden(shipped, tmp_path):
    with pytest.raises(ConfigError, match='is not trained; leave --no-train out'):
        shipped(train=False)
    assert not list(tmp_path.rglob('*.safetensors'))
