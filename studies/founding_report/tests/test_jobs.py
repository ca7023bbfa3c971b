"""Jobs run side by side, in order, once, and stop when they are told to."""

import os
from pathlib import Path
import signal
import subprocess
import sys
import textwrap
import time

import pytest

from founding_report import jobs
from founding_report.jobs import Job, JobError, run_jobs

ROOT = Path(__file__).parents[3]


@pytest.fixture(autouse=True)
def python_instead_of_socialnav(monkeypatch):
    """Let the arguments of a job be a Python program."""
    monkeypatch.setattr(jobs, 'PROGRAM', (sys.executable, '-c'))


@pytest.fixture
def job(tmp_path):
    """Return a function that makes a job which runs a program, and notes in `done` its end."""

    def make(name, program, needed=True, followers=()):
        return Job(
            name, lambda: [program], tmp_path / f'{name}.log', lambda: needed,
            lambda seconds: make.done.append(name), tuple(followers),
        )  # fmt: skip

    make.done = []
    return make


def ignore(line):
    """Say nothing."""


def test_followers_come_after_their_job_and_after_one_that_was_not_needed(job):
    first = job('first', 'pass', followers=[job('second', 'pass')])
    run_jobs([first, job('made', 'pass', False, [job('third', 'pass')])], 2, ignore)
    assert job.done.index('first') < job.done.index('second')
    assert sorted(job.done) == ['first', 'second', 'third']


def test_a_failure_names_its_log_and_stops_its_followers_alone(job, tmp_path):
    bad = job('bad', 'raise SystemExit("no room")', followers=[job('never', 'pass')])
    with pytest.raises(JobError, match=r'bad failed, see .*bad\.log: no room'):
        run_jobs([bad, job('good', 'pass')], 1, ignore)
    assert job.done == ['good']


def test_processes_have_one_thread(job):
    run_jobs([job('one', 'import os; assert os.environ["OMP_NUM_THREADS"] == "1"')], 1, ignore)
    assert job.done == ['one']


def test_jobs_run_side_by_side(job, tmp_path):
    wait = textwrap.dedent("""
        import pathlib, time
        mine, other = pathlib.Path({mine!r}), pathlib.Path({other!r})
        mine.touch()
        deadline = time.monotonic() + 20
        while not other.exists():
            assert time.monotonic() < deadline
            time.sleep(0.01)
    """)
    a, b = str(tmp_path / 'a'), str(tmp_path / 'b')
    pair = [job('a', wait.format(mine=a, other=b)), job('b', wait.format(mine=b, other=a))]
    run_jobs(pair, 2, ignore)
    assert sorted(job.done) == ['a', 'b']


def test_sigterm_lets_the_processes_save_themselves_and_starts_no_others(tmp_path):
    child = (
        'import pathlib, signal, sys, time\n'
        f'folder = pathlib.Path({str(tmp_path)!r})\n'
        'def save(*_):\n    (folder / "saved").touch()\n    sys.exit(1)\n'
        'signal.signal(signal.SIGTERM, save)\n'
        '(folder / "started").touch()\n'
        'time.sleep(60)'
    )
    parent = textwrap.dedent(f"""
        import pathlib, sys
        from founding_report import jobs
        jobs.PROGRAM = (sys.executable, '-c')
        folder = pathlib.Path({str(tmp_path)!r})
        programs = [{child!r}, '(folder / "second").touch()']
        work = [jobs.Job(str(i), lambda p=p: [p], folder / f'{{i}}.log', lambda: True, print)
                for i, p in enumerate(programs)]
        jobs.run_jobs(work, 1, print)
    """)
    process = subprocess.Popen(
        [sys.executable, '-c', parent], cwd=ROOT, env=os.environ, stderr=subprocess.PIPE
    )
    deadline = time.monotonic() + 60
    while not (tmp_path / 'started').exists():
        assert time.monotonic() < deadline
        time.sleep(0.02)
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=60)
    assert b'KeyboardInterrupt' in errors
    assert (tmp_path / 'saved').exists()
    assert not (tmp_path / 'second').exists()
