"""Whatever is typed, a command answers: by its result, or by one line and an exit code."""

import contextlib
import io

from hypothesis import given
from hypothesis import strategies as st
import pytest
from wrong_values import trials, wrong_texts

from socialnav_core import cli

SETTINGS = (
    'scenario.pedestrians', 'scenario.time_step', 'scenario.bounds', 'scenario.orca.max_neighbors',
    'scenario.robot_start', 'scenario.name', 'scenario.reward.discount', 'policy.headings',
    'policy.safety_space', 'policy.time_step', 'training.worlds', 'training.learning_rate', 'seed',
    'training.imitation.episodes', 'name', 'key', 'scenario', 'a.' * 300 + 'a', '', '=', '.', '..',
)  # fmt: skip
WORLD = ('--scenario', 'circle', '--episodes', '1')
# what would run for long is wrong in any case: by --overwrite with --resume, or by its suffix
LINES = (
    ('evaluate', 'straight_line', *WORLD),
    ('evaluate', 'straight_line', *WORLD, '--seed', '1', '--split', 'test', '--threads', '1'),
    ('evaluate', 'orca', *WORLD, '--safety-space', '0.1', '--metrics', 'spl'),
    ('compare', 'straight_line', 'orca', *WORLD),
    ('render', 'straight_line', '--scenario', 'circle', '--case', '0', '--out', 'x.avi'),
    ('report', 'straight_line', *WORLD, '--out', 'page', '--overwrite'),
    ('train', 'quick', '--resume', '--overwrite', '--out', 'run', '--seed', '0'),
    ('train', 'quick', '--resume', '--overwrite', '--init', 'sarl'),
    ('train-prediction', 'mixed', '--resume', '--overwrite', '--threads', '1'),
    ('evaluate-prediction', '--crowds', 'nobody', '--groups', '1', '--seed', '0'),
    ('models', 'nowhere'),
    ('scenarios', 'hard'),
    ('benchmark', 'nothing', '--threads', '1'),
    ('reproduce', 'nothing', '--seeds', '1', '--jobs', '1'),
)  # fmt: skip


@st.composite
def command_lines(draw):
    """Draw a command line that is right but for one word or setting."""
    words = list(draw(st.sampled_from(LINES)))
    if draw(st.booleans()):
        words[draw(st.integers(0, len(words) - 1))] = draw(wrong_texts)
        return words
    return [*words, '--set', f'{draw(st.sampled_from(SETTINGS))}={draw(wrong_texts)}']


def answer(words):
    """Return the exit code of a command and what it wrote on stderr."""
    errors = io.StringIO()
    with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
        try:
            code = cli.main(words)
        except SystemExit as end:
            code = end.code
    return code, errors.getvalue()


def check(count):
    """Try so many command lines; return how many were wrong."""
    wrong = []

    @trials(count)
    @given(command_lines())
    def law(words):
        code, errors = answer(words)
        assert code in (0, 1, 2), (words, code)
        if code:
            assert errors.count('\n') == 1, (words, errors)
            assert errors[:-1].isprintable() and len(errors) < 2000, (words, errors)
            wrong.append(words)

    law()
    print(f'{len(wrong)} of {count} command lines were wrong and answered in one line')
    return len(wrong)


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    """Run everything in a folder of its own."""
    monkeypatch.chdir(tmp_path)


def test_a_wrong_command_line_is_answered_in_one_line():
    assert check(80) > 40


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_a_thousand_wrong_command_lines_are_answered_in_one_line_each():
    assert check(1300) >= 1000
