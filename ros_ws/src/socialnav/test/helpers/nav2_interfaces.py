"""
The interfaces of nav2 for tests: those that are installed, else stand-ins that are built here.

They go into a place of their own in ros_ws/build, so that no user meets them.
"""

from collections.abc import Iterator
import contextlib
import ctypes
import fcntl
import hashlib
from importlib.util import find_spec
import os
from pathlib import Path
import subprocess
import sys
import sysconfig

SOURCES = Path(__file__).parents[1] / 'interfaces'
WORKSPACE = Path(__file__).parents[4]
PLACE = WORKSPACE / 'build' / 'test_interfaces'
PACKAGES = ('nav2_msgs', 'bond')
PYTHON = Path('lib') / f'python{sysconfig.get_python_version()}' / 'site-packages'
loaded: dict[str, object] = {}
"""Modules of the packages, which a process can only load once."""


@contextlib.contextmanager
def nav2_interfaces() -> Iterator[None]:
    """Have nav2's interfaces in this process, and in those that it starts."""
    if all(map(find_spec, PACKAGES)):
        yield
        return
    install = built()
    before, path = dict(os.environ), list(sys.path)
    os.environ.update(with_prefix(os.environ, install))
    sys.path.insert(0, str(install / PYTHON))
    load_libraries(install / 'lib')
    sys.modules.update(loaded)
    try:
        yield
    finally:
        sys.path[:] = path
        for name in [one for one in sys.modules if one.split('.')[0] in PACKAGES]:
            loaded[name] = sys.modules.pop(name)
        os.environ.clear()
        os.environ.update(before)


def built() -> Path:
    """Return where the stand-ins are installed; build them where they are not, or are old."""
    files = sorted(path for path in SOURCES.rglob('*') if path.is_file())
    content = b''.join(str(path).encode() + path.read_bytes() for path in files)
    stamp = hashlib.sha256(content + sys.version.encode()).hexdigest()
    PLACE.mkdir(parents=True, exist_ok=True)
    with (PLACE / 'lock').open('w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = PLACE / 'stamp'
        if not (done.exists() and done.read_text() == stamp):
            done.unlink(missing_ok=True)
            build()
            done.write_text(stamp)
    return PLACE / 'install'


def build() -> None:
    """Build the stand-ins as the workspace is built."""
    command = [
        sys.executable, '-m', 'colcon', '--log-base', str(PLACE / 'log'), 'build',
        '--base-paths', str(SOURCES), '--build-base', str(PLACE / 'build'),
        '--install-base', str(PLACE / 'install'), '--merge-install',
    ]  # fmt: skip
    run = subprocess.run(command, cwd=WORKSPACE, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


def with_prefix(environment: os._Environ, install: Path) -> dict[str, str]:
    """Return the variables by which processes find what is installed in a place."""
    additions = {
        'AMENT_PREFIX_PATH': install,
        'LD_LIBRARY_PATH': install / 'lib',
        'PYTHONPATH': install / PYTHON,
    }
    return {
        name: os.pathsep.join(filter(None, (str(path), environment.get(name))))
        for name, path in additions.items()
    }


def load_libraries(folder: Path) -> None:
    """Load libraries, which this process could not find any more, in an order that works."""
    waiting = sorted(folder.glob('lib*.so'))
    while waiting:
        left = [path for path in waiting if not is_loaded(path)]
        assert len(left) < len(waiting), f'cannot be loaded: {left}'
        waiting = left


def is_loaded(path: Path) -> bool:
    """Return whether a library could be loaded."""
    try:
        ctypes.CDLL(str(path), mode=ctypes.RTLD_GLOBAL)
    except OSError:
        return False
    return True
