"""Laws of `socialnav report`: one page, and one line for every mistake."""

import html
import json
import re
import shlex

import pytest

from socialnav_core import cli
from socialnav_core.commands import report

QUICK = ['--scenario', 'circle', '--episodes', '3']


def run(*words):
    """Return the exit code of a command."""
    try:
        return cli.main([str(word) for word in words])
    except SystemExit as error:
        return error.code


@pytest.fixture
def failing(capsys):
    """Return a function that runs a command which must fail in one line, and returns that."""

    def fail(*words):
        assert run(*words) == 2
        captured = capsys.readouterr()
        assert captured.err.count('\n') == 1 and captured.out == ''
        return captured.err

    return fail


def test_a_page_is_written_and_its_place_told(tmp_path, capsys):
    out = tmp_path / 'new' / 'report'
    words = ['orca', 'sarl', '--scenario', 'circle', 'simple', '--episodes', '3', '--out', out]
    assert run('report', *words, '--seed', 5, '--set', 'scenario.time_limit=20') == 0
    assert capsys.readouterr().out == f'{out / report.PAGE}: open it in a browser\n'
    assert [path.name for path in out.iterdir()] == [report.PAGE]
    text = (out / report.PAGE).read_text()
    data = json.loads(re.search(r'type="application/json">(.*)</script>', text)[1])
    assert [world['scenario'] for world in data['worlds']] == ['circle', 'simple']
    assert 'circle with time_limit=20' in text
    assert 'report orca sarl --scenario circle simple --seed 5 --split test --set' in text
    assert {each['policy'] for each in data['worlds'][1]['episodes']} == {'orca', 'sarl'}
    lines = re.findall(r'(?:data-command="|<code>)(socialnav [^"<]+)', text)
    assert len(lines) == 1 + 2 + sum(len(world['episodes']) for world in data['worlds'])
    for line in lines:  # what is to be typed is understood, and asks for the same cases
        again = cli.build_parser().parse_args(shlex.split(html.unescape(line))[1:])
        assert (again.seed, again.split) == (5, 'test')
        assert again.assignments == ['scenario.time_limit=20']


def test_the_words_of_an_order_ask_for_the_same_again():
    words = ['sarl', 'orca', '--scenario', 'hard', '--out', 'a b', '--set', 'scenario.bounds=8',
             '--lookahead', 'oracle', '--no-screening', '--seed', '4', '--split', 'validation',
             '--safety-space', '0.2', '--episodes', '7', '--grid', 'g.json']  # fmt: skip
    given = cli.build_parser().parse_args(['report', *words])
    again = cli.build_parser().parse_args(list(report.order_of(given).words))
    assert vars(again) == vars(given)


def test_a_taken_folder_is_kept_unless_its_report_may_be_replaced(failing, tmp_path):
    page = tmp_path / report.PAGE
    page.write_text('mine')
    words = ['report', 'straight_line', *QUICK, '--out', tmp_path]
    assert '--overwrite' in failing(*words)
    assert page.read_text() == 'mine'
    assert run(*words, '--overwrite') == 0
    assert '<!doctype html>' in page.read_text()


def test_a_folder_of_other_files_is_never_used(failing, tmp_path):
    (tmp_path / 'thesis.txt').write_text('mine')
    words = ['report', 'straight_line', *QUICK, '--out', tmp_path, '--overwrite']
    assert 'choose another --out' in failing(*words)
    file = tmp_path / 'thesis.txt'
    assert 'cannot be used' in failing('report', 'straight_line', *QUICK, '--out', file)


@pytest.mark.parametrize(
    'words, told',
    [
        (['nobody', *QUICK], 'no model'),
        (['orca', '--scenario', 'crowd2', '--episodes', '3'], 'did you mean crowd20?'),
        (['orca', 'orca', *QUICK], 'name different models'),
        (['orca', '--scenario', 'hard', 'hard'], 'name different scenarios'),
        (['orca', *QUICK, '--set', 'observation.missed=0.1'], 'drop --set observation.'),
        (['orca', *QUICK, '--grid', 'nowhere.json'], 'holds no grid'),
        (['orca', *QUICK, '--set', 'scenario.kinematics=differential'], 'holonomic'),
    ],
)
def test_a_mistake_is_told_in_one_line_before_anything_is_written(words, told, failing, tmp_path):
    out = tmp_path / 'report'
    assert told in failing('report', *words, '--out', out)
    assert not out.exists()


def test_two_worlds_of_one_name_are_refused(failing, tmp_path, capsys):
    assert run('scenarios', 'hard') == 0
    file = tmp_path / 'mine.yaml'
    file.write_text(capsys.readouterr().out)
    words = ['report', 'orca', '--scenario', 'hard', file, '--out', tmp_path / 'report']
    assert 'two worlds are called hard' in failing(*words)
