"""Every metric against an episode worked out by hand, and the ways on which it is told."""

import json
from pathlib import Path
import subprocess
import sys

import numpy as np
import pytest

from socialnav_core import cli
from socialnav_core.metrics import Average, EpisodeRecords, Metric, METRICS, summarise
from socialnav_core.metrics.page import reference_page
from socialnav_core.simulation import Outcome
from socialnav_core.training.model_card import results_section

ROOT = Path(__file__).parents[2]
NAN, INF = np.nan, np.inf

BY_HAND = {
    'success_rate': 1.0,
    'collision_rate': 0.0,
    'collision_pedestrian_rate': 0.0,
    'collision_obstacle_rate': 0.0,
    'out_of_bounds_rate': 0.0,
    'timeout_rate': 0.0,
    'navigation_time_mean': 2.0,
    'path_length_mean': 1.5,
    'spl': 1.2 / 1.5,
    'stalled_time': 0.5,  # the third step
    'minimum_clearance_mean': 0.05,
    'intrusion_rate': 1 / 4,
    'minimum_people_distance': 0.1,
    'intimate_space_compliance': 3 / 4,
    'personal_space_compliance': 2 / 4,
    'social_space_compliance': 1 / 4,
    'minimum_time_to_collision': 1.0,
    'mean_acceleration': (2 + 0 + 2 + 2) / 4,
    'mean_jerk': (4 + 4 + 4 * np.sqrt(2)) / 3,
    'heading_changes': (np.pi / 2) / 1.5,
    'foreseen_intrusion_rate': 1 / 5,
    'solvable_rate': 1.0,
    'solvable_success_rate': 1.0,
    'time_over_bound': 0.5,
    'time_over_comfortable_bound': 0.25,
}
"""Ahead for two steps of 0.5 s at 1 m/s, a pause of one step, one step to the left."""


def by_hand(behind=0):
    """Return the episode of BY_HAND, with some columns behind its end that another one needs."""
    tail = [NAN] * behind
    pairs = [(NAN, NAN)] * behind
    gaps = [[4.0, 1.5, 0.5, 0.1, *tail]]
    return EpisodeRecords(
        case_index=np.array([0]),
        outcome=np.array([Outcome.GOAL], np.int8),
        time=np.array([2.0]),
        path_length=np.array([1.5]),
        minimum_clearance=np.array([0.05]),
        steps=np.array([4]),
        straight_path=np.array([1.2]),
        moment=np.array([[0.0, 0.5, 1.0, 1.5, 2.0, *tail]]),
        position=np.array([[(0, 0), (0.5, 0), (1, 0), (1, 0), (1, 0.5), *pairs]], float),
        velocity=np.array([[(0, 0), (1, 0), (1, 0), (0, 0), (0, 1), *pairs]], float),
        command=np.array([[(1, 0), (1, 0), (0, 0), (0, 1), *pairs]], float),
        clearance=np.array(gaps),
        pedestrian_clearance=np.array(gaps),
        time_to_collision=np.array([[INF, 3.0, 2.0, 1.0, *tail]]),
        foreseen_distance=np.array([[INF, 0.7, 0.5, 0.6, *tail]]),
        bound=np.array([1.5]),
        comfortable_bound=np.array([1.75]),
    )


TOP_SPEED = Metric(
    name='top_speed', label='top speed', unit='m/s', digits=1,
    measure=lambda records: np.nanmax(np.linalg.norm(records.velocity, axis=-1), axis=1),
    average=Average.EPISODES, formula='largest |v(k)| of the states k', source='this test',
)  # fmt: skip


@pytest.fixture
def top_speed(monkeypatch):
    """Put a metric into the table for one test."""
    monkeypatch.setitem(METRICS, TOP_SPEED.name, TOP_SPEED)


@pytest.mark.parametrize('behind', [0, 3])
@pytest.mark.parametrize('name', METRICS)
def test_a_metric_gives_what_was_worked_out_by_hand(name, behind):
    assert METRICS[name].figure(by_hand(behind)) == pytest.approx(BY_HAND[name])


def test_a_failure_counts_nothing_for_success_by_path_length():
    records = by_hand()
    records.outcome[:] = Outcome.TIMEOUT
    assert METRICS['spl'].figure(records) == 0.0


def test_a_detour_shorter_than_the_straight_path_counts_as_that():
    records = by_hand()
    records.path_length[:] = 1.0
    assert METRICS['spl'].figure(records) == 1.0


def test_turning_by_a_half_circle_is_the_same_to_either_side():
    there, back = by_hand(), by_hand()
    there.position[0] = [(0, 0), (1, 0), (0, 1e-9), (-1, 0), (-2, 0)]
    back.position[0] = [(0, 0), (1, 0), (0, -1e-9), (-1, 0), (-2, 0)]
    for records in (there, back):
        assert METRICS['heading_changes'].figure(records) == pytest.approx(np.pi / 1.5)


def test_a_robot_that_never_moved_has_no_heading_to_change():
    records = by_hand()
    records.position[:] = 0.0
    records.path_length[:] = 0.0
    assert METRICS['heading_changes'].figure(records) is None
    assert METRICS['stalled_time'].figure(records) == 2.0


def test_what_is_not_asked_for_is_not_measured():
    assert not {'spl', 'mean_jerk'} & summarise(by_hand()).keys()
    assert summarise(by_hand(), ['spl']).keys() - summarise(by_hand()).keys() == {'spl'}
    assert summarise(by_hand(), ['all']).keys() == METRICS.keys()


def test_keys_of_single_episodes_are_unique():
    keys = [metric.key for metric in METRICS.values() if metric.key is not None]
    assert len(set(keys)) == len(keys)
    assert not {'case_index', 'outcome', 'steps'} & set(keys)


def test_a_new_entry_alone_reaches_console_json_card_and_page(top_speed, tmp_path, capsys):
    file = tmp_path / 'result.json'
    words = ['--scenario', 'simple', '--episodes', '4', '--metrics', 'top_speed']
    assert cli.main(['evaluate', 'straight_line', *words, '--json', str(file)]) == 0
    assert 'top speed                     1.0 m/s\n' in capsys.readouterr().out
    values = json.loads(file.read_text())
    assert values['top_speed'] == pytest.approx(1.0)
    assert [case['top_speed'] for case in values['cases']] == pytest.approx([1.0] * 4)
    card = results_section([values | {'lookahead': 'oracle'}])
    assert '| time, s | top speed, m/s |' in card and card.endswith('| 1.0 |')
    assert '| `top_speed` | largest \\|v(k)\\| of the states k | m/s |' in reference_page()
    assert cli.main(['compare', 'straight_line', 'orca', *words]) == 0
    assert 'top speed' in capsys.readouterr().out
    assert cli.main(['metrics']) == 0
    assert 'top_speed' in capsys.readouterr().out


def test_an_unknown_metric_is_refused_before_anything_runs(capsys):
    words = ['--scenario', 'simple', '--metrics', 'mean_jerks']
    assert cli.main(['evaluate', 'orca', *words]) == 2
    assert 'did you mean mean_jerk?' in capsys.readouterr().err


def test_the_page_of_metrics_is_the_table(capsys):
    assert cli.main(['metrics', '--markdown']) == 0
    page = (ROOT / 'docs' / 'metrics.md').read_text()
    assert capsys.readouterr().out == page, 'run socialnav metrics --markdown > docs/metrics.md'


def test_the_table_loads_without_networks_and_statistics():
    code = (
        'import sys, socialnav_core.metrics; '
        "heavy = {'torch', 'scipy.stats'} & set(sys.modules); "
        'sys.exit(str(heavy) if heavy else 0)'
    )
    run = subprocess.run([sys.executable, '-c', code], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
