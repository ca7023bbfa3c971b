"""Laws of `ros2 run`, with programs of the tests' own."""

from pathlib import Path
import signal
import subprocess

from command_line import DEADLINE, ros2, start, wait_for_line
import pytest

PACKAGE = 'some_package'


@pytest.fixture
def prefix(tmp_path: Path) -> Path:
    """Return a folder that one package is installed in."""
    marker = tmp_path / 'share' / 'ament_index' / 'resource_index' / 'packages' / PACKAGE
    marker.parent.mkdir(parents=True)
    marker.touch()
    return tmp_path


def install(prefix: Path, name: str, script: str) -> None:
    """Install a shell script as an executable of the package."""
    path = prefix / 'lib' / PACKAGE / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f'#!/bin/sh\n{script}\n')
    path.chmod(0o755)


def run(prefix: Path, *arguments: str) -> subprocess.CompletedProcess:
    """Run an executable with the folder behind one that does not hold the package."""
    return ros2('run', *arguments, AMENT_PREFIX_PATH=f'/nowhere:{prefix}')


def test_the_executable_gets_its_arguments_unchanged_and_its_status_is_returned(
    prefix: Path,
) -> None:
    install(prefix, 'program', 'printf "%s|" "$@"; exit 7')
    arguments = ['--ros-args', '-p', 'seed:=3', '-h', 'two words', '--', '-x']
    result = run(prefix, PACKAGE, 'program', *arguments)
    assert (result.stdout, result.returncode) == ('--ros-args|-p|seed:=3|-h|two words|--|-x|', 7)


def test_signals_reach_the_executable(prefix: Path) -> None:
    trap = 'trap "echo told; kill \\$!; exit 3" INT'
    install(prefix, 'program', f'{trap}; sleep 60 & echo ready; wait')
    environment = {'AMENT_PREFIX_PATH': str(prefix), 'PATH': '/usr/bin:/bin'}
    process = start('run', PACKAGE, 'program', environment=environment)
    wait_for_line(process, 'ready')
    process.send_signal(signal.SIGINT)
    text, _ = process.communicate(timeout=DEADLINE)
    assert (text, process.returncode) == ('told\n', 3)


@pytest.mark.parametrize(
    ('package', 'name', 'error'),
    [
        ('other_package', 'program', "Package 'other_package' not found"),
        (PACKAGE, 'other_program', 'No executable found'),
        (PACKAGE, 'twice', 'Multiple executables found:'),
    ],
)
def test_what_cannot_be_run_is_refused(prefix: Path, package: str, name: str, error: str) -> None:
    install(prefix, 'twice', 'true')
    install(prefix, 'deeper/twice', 'true')
    result = run(prefix, package, name)
    assert result.returncode == 1
    assert result.stderr.splitlines()[0] == error


def test_a_file_that_is_not_executable_is_not_run(prefix: Path) -> None:
    install(prefix, 'program', 'true')
    (prefix / 'lib' / PACKAGE / 'program').chmod(0o644)
    assert run(prefix, PACKAGE, 'program').stderr == 'No executable found\n'
