"""Laws of how the programs of this package begin."""

import os
import subprocess
import sys

import pytest

SHOWN = """
import os, types
from socialnav import programs
told = lambda: print(os.environ['OPENBLAS_NUM_THREADS'])
programs.import_module = lambda name: types.SimpleNamespace(main=told)
programs.policy_node()
"""


@pytest.mark.parametrize(('given', 'threads'), [(None, '1'), ('3', '3')])
def test_numpy_computes_with_one_thread_unless_another_number_is_asked_for(given, threads):
    others = {name: value for name, value in os.environ.items() if name != 'OPENBLAS_NUM_THREADS'}
    asked = {} if given is None else {'OPENBLAS_NUM_THREADS': given}
    done = subprocess.run(
        [sys.executable, '-c', SHOWN], env=others | asked, capture_output=True, text=True
    )
    assert done.stdout.strip() == threads, done.stderr
