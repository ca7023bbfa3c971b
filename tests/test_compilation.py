"""Laws of the cache of compiled kernels."""

import os
import subprocess
import sys

import numba
import numpy as np
import pytest

from socialnav_core import compilation


@pytest.fixture
def package(tmp_path, monkeypatch):
    """Return a package with one kernel, forgotten afterwards."""
    for folder in ('simulation', 'policies'):
        (tmp_path / folder / 'inner').mkdir(parents=True)
    (tmp_path / 'simulation' / 'kernel.py').write_text('@compiled\ndef one(): return 1\n')
    monkeypatch.setattr(compilation, 'PACKAGE', tmp_path)
    monkeypatch.delenv('NUMBA_CACHE_DIR', raising=False)
    for function in (compilation.cache_folder, compilation.cache_is_writable):
        function.cache_clear()
    yield tmp_path
    for function in (compilation.cache_folder, compilation.cache_is_writable):
        function.cache_clear()


def test_a_change_of_any_kernel_makes_another_cache(package):
    before = compilation.sources_digest()
    (package / 'policies' / 'inner' / 'caller.py').write_text(
        '@compiled\ndef two(): return one() + 1\n'
    )
    between = compilation.sources_digest()
    (package / 'simulation' / 'kernel.py').write_text('@compiled\ndef one(): return 2\n')
    assert len({before, between, compilation.sources_digest()}) == 3


def test_files_without_kernels_leave_the_cache_as_it_is(package):
    before = compilation.sources_digest()
    (package / 'policies' / 'plain.py').write_text('def three(): return 3\n')
    assert compilation.sources_digest() == before


def test_a_package_that_cannot_be_written_to_is_cached_for_the_user(package, monkeypatch):
    monkeypatch.setattr(os, 'access', lambda *_: False)
    monkeypatch.setenv('XDG_CACHE_HOME', str(package / 'cache'))
    assert compilation.cache_folder().parts[-4:-1] == ('cache', 'socialnav', 'kernels')


def test_an_installed_package_is_cached_for_the_user(package, monkeypatch):
    monkeypatch.setattr(compilation, 'CHECKOUT', None)
    monkeypatch.setenv('XDG_CACHE_HOME', str(package / 'cache'))
    assert compilation.cache_folder().parts[-4:-1] == ('cache', 'socialnav', 'kernels')


def test_where_nothing_can_be_kept_kernels_are_compiled_all_the_same(package, monkeypatch):
    (package / 'file').write_text('')
    monkeypatch.setattr(compilation, 'CHECKOUT', None)
    monkeypatch.setenv('XDG_CACHE_HOME', str(package / 'file'))
    with pytest.warns(UserWarning, match='NUMBA_CACHE_DIR'):
        negate = compilation.compiled(lambda x: -x)
    assert negate(3) == -3


def test_code_that_is_reached_through_a_link_is_cached_as_the_file_itself(package):
    (package / 'link').symlink_to(package / 'simulation')
    code = compile('def one():\n    return 1\n', package / 'link' / 'kernel.py', 'exec')
    names = {}
    exec(code, names)
    assert compilation.compiled(names['one'])() == 1
    assert names['one'].__code__.co_filename == str(package / 'simulation' / 'kernel.py')


def test_a_compiled_function_leaves_other_users_of_numba_alone():
    before = numba.config.CACHE_DIR

    @compilation.compiled
    def double(x):  # type: ignore[no-untyped-def]
        return 2 * x

    assert np.array_equal(double(np.arange(3)), [0, 2, 4])
    assert before == numba.config.CACHE_DIR


NAMED = """
from typing import NamedTuple
import numpy as np
from socialnav_core.compilation import compiled

class Pair(NamedTuple):
    numbers: np.ndarray
    factor: float

@compiled
def product(pair):
    return pair.numbers[0] * pair.factor

@compiled
def of_plain(pair):
    return product(Pair(*pair))

arguments = Pair(np.array([3.0]), 2.0)
assert product(arguments) == of_plain(tuple(arguments)) == 6.0
hits = [sum(kernel.stats.cache_hits.values()) for kernel in (product, of_plain)]
print(*hits)
"""


def test_kernels_of_named_tuples_come_from_the_cache_in_another_process(tmp_path):
    script = tmp_path / 'named.py'
    script.write_text(NAMED)
    environment = os.environ | {'NUMBA_CACHE_DIR': str(tmp_path / 'cache')}
    environment['PYTHONPATH'] = str(compilation.PACKAGE.parent)

    def hits():
        command = [sys.executable, '-c', 'import named']
        run = subprocess.run(
            command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=True
        )
        return run.stdout.split()

    assert hits() == ['0', '0']
    assert hits() == ['1', '1']
