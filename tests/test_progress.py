"""Laws of progress: a bar on a terminal of any size, elsewhere a line a minute."""

import fcntl
import os
import pty
import struct
import subprocess
import sys
import termios

import pytest

from socialnav_core import progress
from socialnav_core.evaluation import evaluate
from socialnav_core.policies import StraightLinePolicy
from socialnav_core.simulation import make_scenario

CODE = """
from socialnav_core.progress import progress_bar
with progress_bar(4, 'crossing') as bar:
    bar.update(1)
    bar.refresh()
"""


@pytest.mark.parametrize('columns', [0, 60])
def test_the_bar_shows_on_a_pseudo_terminal_of_any_width(columns):
    ours, theirs = pty.openpty()
    fcntl.ioctl(
        theirs, termios.TIOCSWINSZ, struct.pack('HHHH', 24 if columns else 0, columns, 0, 0)
    )
    subprocess.run([sys.executable, '-c', CODE], stderr=theirs, check=True, timeout=120)
    os.close(theirs)
    shown = os.read(ours, 10_000).decode()
    os.close(ours)
    assert 'crossing:  25%|' in shown
    assert '1/4' in shown


def test_without_a_terminal_a_line_is_said_each_minute(monkeypatch, capsys):
    now = [0.0]
    monkeypatch.setattr(progress.time, 'monotonic', lambda: now[0])
    with progress.progress_bar(9, 'crossing', initial=1) as bar:
        for moment in (30.0, 59.0, 61.0, 100.0, 122.0):
            now[0] = moment
            bar.update(1)
        bar.set_postfix_str('success 0.5')
        now[0] = 200.0
        bar.update(1)
    assert capsys.readouterr().err.splitlines() == [
        'crossing: 4 of 9 episodes after 1 min',
        'crossing: 6 of 9 episodes after 2 min',
        'crossing: 7 of 9 episodes after 3 min, success 0.5',
    ]


def test_nothing_is_said_where_nothing_is_to_be_said(capsys, monkeypatch):
    monkeypatch.setattr(progress, 'PERIOD', 0.0)
    with progress.progress_bar(9, 'crossing', visible=False) as bar:
        bar.update(1)
    assert capsys.readouterr().err == ''


def test_evaluation_says_how_it_goes_where_that_is_wanted(capsys, monkeypatch):
    monkeypatch.setattr(progress, 'PERIOD', 0.0)
    evaluate(StraightLinePolicy(), make_scenario('circle'), 3)
    assert capsys.readouterr().err == ''
    evaluate(StraightLinePolicy(), make_scenario('circle'), 3, name='straight', progress=True)
    assert 'straight: 3 of 3 episodes' in capsys.readouterr().err
    counts = []
    evaluate(StraightLinePolicy(), make_scenario('circle'), 3, progress=counts.append)
    assert sum(counts) == 3
