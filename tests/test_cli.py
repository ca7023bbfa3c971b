"""The socialnav command: exit codes, errors of one line, no file written by mistake."""

import json
from pathlib import Path
import shlex
import shutil
import signal
import subprocess
import sys

from PIL import Image
import pytest
import torch

from socialnav_core import __version__, cli
from socialnav_core.commands import arguments, files, render
from socialnav_core.commands.arguments import one_line
from socialnav_core.commands.models import headline
from socialnav_core.config import Config, PolicyConfig, SearchConfig
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.policies import build_network
from socialnav_core.policies.search.checkpoint import save_planner
from socialnav_core.policies.value import checkpoint as checkpoints
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.simulation import make_scenario
from socialnav_core.simulation.random_streams import SPLITS
from socialnav_core.training import TrainingInterrupted

QUICK = ['--scenario', 'simple', '--episodes', '6']
JSON_FIELDS = {
    'model', 'scenario', 'seed', 'episodes', 'lookahead', 'knowledge', 'success_rate',
    'success_interval',
    'collision_rate', 'collision_pedestrian_rate', 'collision_obstacle_rate',
    'out_of_bounds_rate', 'timeout_rate', 'navigation_time_mean', 'path_length_mean',
    'minimum_clearance_mean', 'intrusion_rate', 'decisions_per_second', 'cases', 'screening',
    'split', 'settings',
}  # fmt: skip


def run(*words):
    """Return the exit code of a command."""
    try:
        return cli.main([str(word) for word in words])
    except SystemExit as error:
        return error.code


@pytest.fixture
def failing(capsys, tmp_path, monkeypatch):
    """Return a function that runs a command which must fail in one line and write nothing."""
    monkeypatch.chdir(tmp_path)

    def fail(code, *words):
        before = sorted(tmp_path.rglob('*'))
        assert run(*words) == code
        captured = capsys.readouterr()
        assert captured.err.count('\n') == 1, captured.err
        assert captured.out == ''
        assert sorted(tmp_path.rglob('*')) == before
        return captured.err

    return fail


@pytest.fixture(scope='module')
def checkpoint(tmp_path_factory):
    """Return the folder of an untrained model."""
    folder = tmp_path_factory.mktemp('models') / 'untrained'
    torch.manual_seed(0)
    config = Config('untrained', make_scenario('simple'), PolicyConfig())
    save_weights(folder, build_network(config.policy), config)
    return folder


COMMANDS = (
    'train', 'evaluate', 'compare', 'render', 'benchmark', 'models', 'scenarios', 'reproduce',
    'train-prediction', 'evaluate-prediction', 'settings', 'bound', 'grid', 'export',
    'train-planner', 'crowds', 'report',
)  # fmt: skip


@pytest.mark.parametrize('command', COMMANDS)
def test_every_command_has_help_with_examples(command, capsys):
    assert run(command, '--help') == 0
    assert f'examples:\n  socialnav {command}' in capsys.readouterr().out


def test_the_version_is_printed(capsys):
    assert run('--version') == 0
    assert capsys.readouterr().out == f'socialnav {__version__}\n'


def test_help_names_every_command(capsys):
    assert run('--help') == 0
    text = capsys.readouterr().out
    assert all(command in text for command in COMMANDS)


def test_the_splits_are_those_of_the_simulator():
    assert tuple(SPLITS) == arguments.SPLITS


@pytest.mark.parametrize(
    'words',
    [
        [],
        ['evaluat'],
        ['evaluate'],
        ['evaluate', 'orca'],
        ['evaluate', 'orca', '--scenario', 'simple', '--episodes', '0'],
        ['evaluate', 'orca', '--scenario', 'simple', '--seed', '-1'],
        ['evaluate', 'orca', '--scenario', 'simple', '--split', 'exam'],
        ['evaluate', 'orca', '--scenario', 'simple', '--safety-space', 'nan'],
        ['evaluate', 'orca', '--scenario', 'simple', '--lookahead', 'oracle'],
        ['evaluate', 'sarl', '--scenario', 'simple', '--lookahead', 'psychic'],
        ['compare', 'orca', 'straight_line', *QUICK, '--lookahead', 'oracle'],
        ['train', 'quick', '--set', 'policy.lookahead=psychic'],
        ['train', 'quick', '--set', 'training.lookahead=psychic'],
        ['evaluate', 'sarl', *QUICK, '--safety-space', '0.2'],
        ['evaluate', 'straight_line', *QUICK, '--safety-space', '0.2'],
        ['evaluate', 'orca', '--scenario', 'simple', '--card'],
        ['evaluate', 'sarl', '--scenario', 'simple', '--card', '--set', 'scenario.bounds=8'],
        ['compare', 'orca', *QUICK],
        ['compare', 'orca', 'orca', *QUICK],
        ['compare', 'sarl', 'straight_line', *QUICK, '--safety-space', '0.2'],
        ['render', 'orca', '--scenario', 'simple', '--out', 'episode.avi'],
        ['models', 'nowhere'],
        ['scenarios', 'nowhere'],
        ['train', 'nowhere'],
        ['train', 'quick', '--set', 'training.worlds=none'],
        ['benchmark', 'everything'],
    ],
)
def test_a_mistake_in_what_is_asked_for_exits_with_2(words, failing):
    failing(2, *words)


def test_an_unknown_scenario_names_the_nearest(failing):
    assert 'did you mean crowd20?' in failing(2, 'evaluate', 'orca', '--scenario', 'crowd2')


def test_an_unknown_setting_names_the_nearest(failing):
    words = ['evaluate', 'orca', *QUICK, '--set', 'scenario.time_limt=35']
    assert 'did you mean time_limit?' in failing(2, *words)


def test_a_setting_without_a_section_says_where_it_belongs(failing):
    words = ['evaluate', 'orca', *QUICK, '--set', 'time_limit=35']
    assert 'begin it with scenario.' in failing(2, *words)


def test_a_missing_model_names_those_that_there_are(failing):
    assert 'orca' in failing(2, 'evaluate', 'nobody', *QUICK)


def test_a_damaged_model_fails_in_one_line(failing, checkpoint, tmp_path_factory):
    damaged = tmp_path_factory.mktemp('damaged')
    for file in checkpoint.iterdir():
        (damaged / file.name).write_bytes(file.read_bytes()[:-9])
    failing(1, 'evaluate', damaged, *QUICK)


def test_a_world_that_cannot_be_laid_out_names_the_settings_to_change(failing):
    words = ['evaluate', 'orca', *QUICK, '--set', 'scenario.obstacles=500']
    assert 'lower obstacles' in failing(2, *words)


def test_an_error_has_no_traceback_in_a_process_of_its_own(tmp_path):
    words = [sys.executable, '-m', 'socialnav_core.cli', 'evaluate', 'orca', '--scenario', 'hrad']
    root = Path(__file__).parents[1]
    done = subprocess.run(words, cwd=root, capture_output=True, text=True, timeout=120)
    assert done.returncode == 2
    assert done.stderr.startswith('socialnav evaluate: ')
    assert done.stderr.count('\n') == 1


def test_evaluate_prints_rates_with_intervals_and_nothing_on_stderr(capsys):
    assert run('evaluate', 'orca', *QUICK) == 0
    captured = capsys.readouterr()
    assert 'orca in simple: 6 cases of test, seed 0' in captured.out
    assert captured.out.count('[') == 3
    assert captured.err == ''


def test_the_search_takes_settings_and_refuses_those_that_it_lacks(capsys):
    assert run('evaluate', 'search', *QUICK, '--set', 'policy.goal_tolerance=0.2') == 0
    assert 'search' in capsys.readouterr().out
    assert run('evaluate', 'search', *QUICK, '--set', 'policy.goal_tolerence=0.2') == 2
    assert 'goal_tolerance' in capsys.readouterr().err


def test_the_search_drives_the_robot_that_the_scenario_has(capsys):
    settings = ('scenario.kinematics=differential', 'scenario.robot_acceleration=1')
    assert run('evaluate', 'search', *QUICK, '--set', *settings) == 0
    assert 'search' in capsys.readouterr().out


def test_a_planner_for_a_differential_drive_brings_its_base_into_the_world(tmp_path, capsys):
    search = SearchConfig(kinematics='differential', horizon=1.0)
    save_planner(tmp_path, build_network(PolicyConfig()), PlannerConfig('turning', policy=search))
    assert run('evaluate', tmp_path, *QUICK) == 0
    said = capsys.readouterr().out
    assert 'kinematics=differential' in said and 'robot_turn_rate=1.5' in said
    assert run('evaluate', tmp_path, *QUICK, '--set', 'scenario.kinematics=holonomic') == 2
    assert 'set scenario.kinematics=differential' in capsys.readouterr().err


def test_evaluate_writes_every_figure_and_case(tmp_path):
    file = tmp_path / 'new' / 'folder' / 'result.json'
    assert run('evaluate', 'straight_line', *QUICK, '--seed', 3, '--json', file) == 0
    values = json.loads(file.read_text())
    assert values.keys() >= JSON_FIELDS
    assert [case['case_index'] for case in values['cases']] == list(range(6))
    total = values['success_rate'] + values['collision_rate'] + values['timeout_rate']
    assert total == pytest.approx(1.0)
    assert (values['seed'], values['split'], values['lookahead']) == (3, 'test', None)


def test_the_same_seed_gives_the_same_numbers(tmp_path):
    files = [tmp_path / name for name in ('a.json', 'b.json')]
    for file in files:
        assert run('evaluate', 'orca', *QUICK, '--json', file) == 0
    first, second = (json.loads(file.read_text()) for file in files)
    assert first['cases'] == second['cases']


def test_an_existing_file_is_kept_unless_it_may_be_replaced(failing, tmp_path):
    file = tmp_path / 'result.json'
    file.write_text('mine')
    assert '--overwrite' in failing(2, 'evaluate', 'orca', *QUICK, '--json', file)
    assert file.read_text() == 'mine'
    assert run('evaluate', 'orca', *QUICK, '--json', file, '--overwrite') == 0
    assert json.loads(file.read_text())['model'] == 'orca'


def test_settings_reach_the_world_and_are_reported(tmp_path):
    file = tmp_path / 'result.json'
    words = ['--set', 'scenario.time_limit=1', 'scenario.pedestrians=0', 'scenario.obstacles=0']
    assert run('evaluate', 'straight_line', *QUICK, *words, '--json', file) == 0
    values = json.loads(file.read_text())
    assert values['timeout_rate'] == 1.0
    assert {case['time'] for case in values['cases']} == {1.0}
    assert values['minimum_clearance_mean'] is None
    assert values['settings']['scenario.time_limit'] == 1


def test_switches_and_settings_reach_the_policy(checkpoint, tmp_path):
    file = tmp_path / 'result.json'
    switches = ['--lookahead', 'oracle', '--screening', '--set', 'policy.headings=4']
    assert run('evaluate', checkpoint, *QUICK, *switches, '--json', file) == 0
    values = json.loads(file.read_text())
    assert (values['lookahead'], values['screening']) == ('oracle', True)
    assert values['knowledge'] == 'oracle'
    assert run('evaluate', checkpoint, *QUICK, '--json', file, '--overwrite') == 0
    values = json.loads(file.read_text())
    assert (values['lookahead'], values['screening']) == ('constant_velocity', False)


def test_what_a_prediction_knows_is_printed_with_its_results(checkpoint, tmp_path, capsys):
    assert run('evaluate', checkpoint, *QUICK, '--lookahead', 'oracle') == 0
    assert 'look-ahead oracle (oracle)' in capsys.readouterr().out
    assert run('compare', 'orca', checkpoint, *QUICK) == 0
    assert 'constant_velocity (deployable)' in capsys.readouterr().out
    assert run('render', checkpoint, '--scenario', 'simple', '--out', tmp_path / 'paths.png') == 0
    assert 'constant_velocity (deployable)' in capsys.readouterr().out


def test_a_checkpoint_is_read_once_for_its_card(checkpoint, monkeypatch):
    read, files = checkpoints.read_tensors, []
    monkeypatch.setattr(checkpoints, 'read_tensors', lambda path: files.append(path) or read(path))
    assert run('evaluate', checkpoint, '--scenario', 'circle', '--episodes', 2, '--card') == 0
    assert len(files) == 1


def test_what_was_fixed_in_training_cannot_be_set(failing, checkpoint):
    words = ['evaluate', checkpoint, *QUICK, '--set', 'policy.network=gat4sn']
    assert 'fixed when' in failing(2, *words)


def test_a_result_can_be_added_to_the_card_of_a_model(checkpoint, capsys):
    assert run('evaluate', checkpoint, *QUICK, '--card') == 0
    assert json.loads((checkpoint / 'metrics.json').read_text())['simple']['episodes'] == 6
    assert '| simple |' in (checkpoint / 'README.md').read_text()
    assert run('models', checkpoint.parent) == 0
    table = capsys.readouterr().out
    assert 'untrained' in table
    assert '96,502' in table


def test_a_card_keeps_more_cases_and_those_of_the_test_split(failing, checkpoint, capsys):
    words = ['evaluate', checkpoint, '--scenario', 'circle', '--card', '--episodes']
    assert run(*words, 3) == 0
    capsys.readouterr()
    assert '3 test cases of circle' in failing(2, *words, 2)
    assert '--overwrite' in failing(2, *words, 4, '--split', 'validation')
    assert run(*words, 4) == 0
    assert run(*words, 2, '--split', 'validation', '--overwrite') == 0
    kept = json.loads((checkpoint / 'metrics.json').read_text())['circle']
    assert (kept['episodes'], kept['split']) == (2, 'validation')


def test_the_card_of_a_model_of_an_installed_package_stays_as_it_is(
    failing, checkpoint, monkeypatch
):
    monkeypatch.setattr(files, 'CHECKOUT', None)
    monkeypatch.setattr(files, 'MODELS', checkpoint.parent)
    assert 'copy it' in failing(2, 'evaluate', checkpoint, *QUICK, '--card', '--overwrite')


def test_a_headline_names_the_split_where_it_is_not_test():
    result = {'scenario': 'hard', 'success_rate': 0.5, 'navigation_time_mean': 9, 'split': 'test'}
    assert headline(result) == 'hard 0.500 (9.00 s)'
    assert headline(result | {'split': 'validation'}) == 'hard 0.500 (9.00 s, validation)'
    changes = {'split': 'validation', 'navigation_time_mean': None}
    assert headline(result | changes) == 'hard 0.500 (validation)'


def test_compare_pairs_the_models_on_the_same_cases(tmp_path, capsys):
    file = tmp_path / 'comparison.json'
    assert run('compare', 'orca', 'straight_line', *QUICK, '--json', file) == 0
    assert 'McNemar' in capsys.readouterr().out
    values = json.loads(file.read_text())
    assert [result['model'] for result in values['results']] == ['orca', 'straight_line']
    assert values['comparisons'][0]['first_only'] >= 0


def test_options_of_networks_leave_the_baselines_of_a_comparison_alone(checkpoint):
    words = ['compare', 'orca', checkpoint, *QUICK, '--lookahead', 'oracle']
    assert run(*words) == 0


@pytest.mark.parametrize('suffix', ['gif', 'png'])
def test_render_writes_a_picture_and_says_what_is_in_it(suffix, tmp_path, capsys):
    file = tmp_path / 'pictures' / f'episode.{suffix}'
    assert run('render', 'straight_line', '--scenario', 'circle', '--out', file) == 0
    with Image.open(file) as picture:
        assert picture.format == suffix.upper()
    assert f'{file}: ' in capsys.readouterr().out
    assert [path.name for path in file.parent.iterdir()] == [file.name]


def test_render_writes_a_bag_and_no_picture_unless_that_is_wanted(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = ['render', 'straight_line', '--scenario', 'circle', '--bag', 'bags/episode.mcap']
    assert run(*words) == 0
    assert [path.name for path in tmp_path.rglob('*.*')] == ['episode.mcap']
    assert 'bags/episode.mcap: ' in capsys.readouterr().out
    assert run(*words, '--overwrite', '--out', 'episode.png') == 0
    assert {path.name for path in tmp_path.rglob('*.*')} == {'episode.mcap', 'episode.png'}


def test_render_refuses_a_bag_that_cannot_be_written_before_anything_is_run(failing, tmp_path):
    words = ['render', 'orca', '--scenario', 'simple', '--bag']
    assert 'must end in .mcap' in failing(2, *words, 'episode.db3')
    (tmp_path / 'file').write_text('')
    assert 'cannot be written' in failing(2, *words, 'file/episode.mcap')


def test_render_keeps_an_existing_picture(failing, tmp_path):
    file = tmp_path / 'episode.png'
    file.write_text('mine')
    failing(2, 'render', 'orca', '--scenario', 'simple', '--out', file)


def test_train_makes_a_model_that_can_be_evaluated(tmp_path, capsys):
    tiny = {
        'scenario.pedestrians': 2, 'scenario.obstacles': 1, 'scenario.time_limit': 15,
        'training.worlds': 4, 'training.iterations': 2, 'training.steps_per_iteration': 4,
        'training.updates_per_iteration': 1, 'training.batch_size': 8,
        'training.replay_capacity': 200, 'training.imitation.episodes': 4,
        'training.imitation.epochs': 1,
    }  # fmt: skip
    settings = [f'{key}={value}' for key, value in tiny.items()]
    out = tmp_path / 'run'
    assert run('train', 'quick', '--set', *settings, '--out', out, '--seed', 4) == 0
    assert run('evaluate', out, *QUICK) == 0
    assert 'seed: 4' in (out / 'config.yaml').read_text()
    assert 'validation' in json.dumps(json.loads((out / 'metrics.json').read_text()))
    assert run('train', 'quick', '--set', *settings, '--out', out, '--seed', 4) == 2
    assert '--resume' in capsys.readouterr().err


def test_scenarios_lists_all_and_prints_one(capsys):
    assert run('scenarios') == 0
    assert 'curriculum-R' in capsys.readouterr().out
    assert run('scenarios', 'packed-1.5') == 0
    assert 'obstacle_radius_max: 1.5' in capsys.readouterr().out


def test_threads_are_those_that_were_asked_for():
    before = torch.get_num_threads()
    try:
        assert run('evaluate', 'orca', *QUICK, '--threads', 2) == 0
        assert torch.get_num_threads() == 2
        assert run('evaluate', 'orca', *QUICK) == 0
        assert torch.get_num_threads() == 1
    finally:
        torch.set_num_threads(before)


def test_a_world_of_ones_own_is_given_as_a_file(tmp_path, capsys):
    file = tmp_path / 'hall.yaml'
    assert run('scenarios', 'hard') == 0
    file.write_text(capsys.readouterr().out.replace('name: hard', 'name: hall'))
    assert run('evaluate', 'orca', '--scenario', file, '--episodes', 4) == 0
    assert 'orca in hall: 4 cases' in capsys.readouterr().out
    assert run('compare', 'orca', 'straight_line', '--scenario', file, '--episodes', 4) == 0
    picture = tmp_path / 'hall.png'
    assert run('render', 'orca', '--scenario', file, '--out', picture) == 0
    assert picture.is_file()


def test_results_of_a_changed_world_say_so(tmp_path, capsys):
    file = tmp_path / 'result.json'
    words = [*QUICK, '--set', 'scenario.pedestrians=1', '--json', file]
    assert run('evaluate', 'orca', *words) == 0
    assert 'orca in simple with pedestrians=1: 6 cases' in capsys.readouterr().out
    assert json.loads(file.read_text())['changes'] == {'pedestrians': 1}
    assert run('compare', 'orca', 'straight_line', *words, '--overwrite') == 0
    assert 'simple with pedestrians=1: 6 cases' in capsys.readouterr().out
    words = ['--scenario', 'circle', '--set', 'scenario.robot_goal=[1, 4]']
    assert run('render', 'straight_line', *words, '--out', tmp_path / 'a.png') == 0
    assert 'circle with robot_goal=(1.0, 4.0)' in capsys.readouterr().out


STOPPED = """
import os, signal, sys
from socialnav_core import cli
from socialnav_core.commands import metrics
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored where tests run behind
metrics.run = lambda given: os.kill(os.getpid(), int(sys.argv[1])) or signal.pause()
sys.exit(cli.main(['metrics']))
"""


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_command_with_its_number(number):
    root = Path(__file__).parents[1]
    words = [sys.executable, '-c', STOPPED, str(int(number))]
    done = subprocess.run(words, cwd=root, capture_output=True, text=True, timeout=120)
    assert done.returncode == 128 + number
    assert done.stderr in ('socialnav metrics: interrupted\n', 'socialnav metrics: terminated\n')


@pytest.mark.skipif(not Path('/dev/full').exists(), reason='only Linux has a disk that is full')
def test_a_full_disk_behind_standard_output_is_told_in_one_line():
    root = Path(__file__).parents[1]
    words = [sys.executable, '-m', 'socialnav_core.cli', 'metrics']
    with open('/dev/full', 'w') as full:
        done = subprocess.run(
            words, cwd=root, stdout=full, stderr=subprocess.PIPE, text=True, timeout=120
        )
    assert done.returncode == 1
    assert done.stderr.endswith("No space left on device: 'standard output'\n")
    assert done.stderr.count('\n') == 1


def test_a_message_is_one_line_that_a_terminal_obeys_in_nothing():
    assert one_line('a\nb\x1b[2J\x07') == 'a b\\x1b[2J\\x07'
    assert len(one_line('x' * 10**6)) < 1000


@pytest.mark.parametrize('example', render.EXAMPLES.splitlines())
def test_the_examples_of_render_reach_their_goals(example, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run('render', *shlex.split(example)) == 0
    assert 'goal reached' in capsys.readouterr().out


@pytest.mark.parametrize(
    'text', ['{', '[]', '{"simple": 3}', '{"simple": {}}', '\x00', '[' * 9999]
)
def test_damaged_metrics_of_a_model_are_told_in_its_row(text, checkpoint, tmp_path, capsys):
    shutil.copytree(checkpoint, tmp_path / 'models' / 'one')
    (tmp_path / 'models' / 'one' / 'metrics.json').write_text(text)
    assert run('models', tmp_path / 'models') == 0
    assert 'metrics.json is damaged' in capsys.readouterr().out


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_training_that_saved_itself_ends_with_the_number_of_the_signal(number, monkeypatch):
    def stopped(given):
        raise TrainingInterrupted('go on with ...', number)

    monkeypatch.setattr('socialnav_core.commands.metrics.run', stopped)
    assert run('metrics') == 128 + number
