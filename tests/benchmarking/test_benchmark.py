"""Benchmarks measure both sides in turns and report figures that are true."""

import json
import time

import pytest

from socialnav_core import cli
from socialnav_core.benchmarking import lookahead, reference, simulator
from socialnav_core.benchmarking.measurement import calls_per_second, in_turns


def test_a_rate_is_that_of_the_function():
    assert calls_per_second(lambda: time.sleep(0.01), 0.2) == pytest.approx(100, rel=0.3)


def test_both_sides_are_measured_in_turns():
    order = []
    value, plain, ratio = in_turns(
        lambda: order.append('ours') or 30.0, lambda: order.append('plain') or 10.0, rounds=3
    )
    assert order == ['ours', 'plain'] * 3
    assert (value, plain, ratio) == (30.0, 10.0, 3.0)


def test_the_ratio_is_that_of_single_turns():
    ours, plain = iter([100.0, 10.0, 50.0]), iter([10.0, 1.0, 5.0])  # the machine slows down
    assert in_turns(lambda: next(ours), lambda: next(plain), rounds=3)[2] == 10.0


def test_without_a_reference_there_is_no_ratio():
    assert in_turns(lambda: 5.0, None, rounds=3) == (5.0, None, None)


def test_a_missing_reference_says_what_is_missing(monkeypatch, tmp_path):
    monkeypatch.setattr(reference, 'REFERENCE', tmp_path / 'reference.py')
    assert 'ratios need a checkout' in reference.load_reference()


@pytest.fixture
def short(monkeypatch):
    monkeypatch.setattr(simulator, 'SECONDS', 0.02)
    monkeypatch.setattr(simulator, 'ROUNDS', 1)
    monkeypatch.setattr(lookahead, 'ROUNDS', 1)
    monkeypatch.setattr(lookahead, 'REPEATS', 5)
    monkeypatch.setattr(lookahead, 'REFERENCE_REPEATS', 1)


def test_the_simulator_is_measured_beside_the_reference(short, tmp_path, capsys):
    file = tmp_path / 'benchmark.json'
    assert cli.main(['benchmark', 'simulator', '--json', str(file)]) == 0
    assert '20 pedestrians' in capsys.readouterr().out
    values = json.loads(file.read_text())
    first = values['measurements'][0]
    assert first['value'] > first['reference'] > 0
    assert first['ratio'] == pytest.approx(first['value'] / first['reference'])
    assert values['processor']


@pytest.mark.parametrize('prediction', ['constant_velocity', 'oracle'])
def test_decisions_are_measured_beside_the_reference(short, prediction):
    module = reference.load_reference()
    measurement = lookahead.decision('gat4sn', 4, 1, 4, prediction, module)
    assert 0 < measurement.value < 1000
    assert measurement.ratio == pytest.approx(measurement.reference / measurement.value)
