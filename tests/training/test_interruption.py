"""Laws of stopping a run from outside."""

import dataclasses
import os
import signal
import subprocess
import sys
import time

import pytest

from socialnav_core.config.mapping import to_yaml
from socialnav_core.policies.value.checkpoint import checkpoint_digest
from socialnav_core.training import train

SCRIPT = """
import sys
from pathlib import Path
from socialnav_core.config import read_config
from socialnav_core.training import TrainingInterrupted, train
try:
    train(read_config(sys.argv[1]), Path(sys.argv[2]), progress=False)
except TrainingInterrupted as stop:
    print(stop)
"""
KILLING_ITSELF = """
import itertools, os, signal
from pathlib import Path
count, replace, number = itertools.count(1), Path.replace, int(sys.argv[3])
def replace_or_die(self, target):
    if next(count) == number:
        os.kill(os.getpid(), signal.SIGKILL)
    return replace(self, target)
Path.replace = replace_or_die
"""
"""Kills the process when it is about to put a file in its place, the number-th time."""
DEADLINE = 60.0


def start(config, folder, killed_at=None):
    """Start a run in another process, which may kill itself at one of its writes."""
    path = folder.with_suffix('.yaml')
    path.write_text(to_yaml(config))
    script = SCRIPT if killed_at is None else f'import sys\n{KILLING_ITSELF}{SCRIPT}'
    arguments = [sys.executable, '-c', script, str(path), str(folder), str(killed_at)]
    return subprocess.Popen(
        arguments,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=os.environ | {'OMP_NUM_THREADS': '1'},
    )


def wait_for_state(process, folder):
    """Wait until the first state is saved."""
    end = time.monotonic() + DEADLINE
    while not (folder / 'training_state.safetensors').exists():
        assert process.poll() is None and time.monotonic() < end, 'no state was saved'
        time.sleep(0.01)


@pytest.fixture
def longer_config(tiny_config):
    """Return a run that lasts long enough to be hit by a signal."""
    training = dataclasses.replace(tiny_config.training, iterations=40)
    return dataclasses.replace(tiny_config, training=training)


@pytest.mark.parametrize('killed_at', [7, 8, 9, 21], ids=['config', 'weights', 'state', 'card'])
def test_killed_run_resumes_to_the_weights_of_an_uninterrupted_one(
    tiny_config, tmp_path, killed_at
):
    train(tiny_config, tmp_path / 'whole', progress=False)
    process = start(tiny_config, tmp_path / 'cut', killed_at)
    process.communicate(timeout=DEADLINE)
    assert process.returncode == -signal.SIGKILL
    train(tiny_config, tmp_path / 'cut', resume=True, progress=False)
    assert checkpoint_digest(tmp_path / 'cut') == checkpoint_digest(tmp_path / 'whole')


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_stopped_run_saves_itself_and_says_how_to_go_on(longer_config, tmp_path, number):
    process = start(longer_config, tmp_path / 'run')
    wait_for_state(process, tmp_path / 'run')
    os.kill(process.pid, number)
    output, _ = process.communicate(timeout=DEADLINE)
    assert f'socialnav train {tmp_path}/run/config.yaml --out {tmp_path}/run --resume' in output
    assert (tmp_path / 'run' / 'training_state.safetensors').exists()
    train(longer_config, tmp_path / 'run', resume=True, progress=False)
    assert not (tmp_path / 'run' / 'training_state.safetensors').exists()
