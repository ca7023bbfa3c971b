"""Laws of the scripts behind make."""

import os
from pathlib import Path
import shutil
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[1]
SHOW = 'source scripts/{}; echo "$ROUTE,${{{}-unset}}"'


def shell(script, **variables):
    """Run bash in the repository, without a sourced ROS; return what it prints."""
    environment = {'PATH': '/usr/bin:/bin', 'HOME': os.environ['HOME']} | variables
    return subprocess.run(
        ['bash', '-c', script], cwd=ROOT, env=environment, capture_output=True, text=True
    )


@pytest.mark.parametrize(
    ('name', 'value'),
    [
        ('PYTHONPATH', '/opt/ros/humble/lib/python3.10/site-packages'),
        ('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp'),
        ('ROS_DISTRO', 'humble'),
        ('AMENT_PREFIX_PATH', f'{ROOT}/ros_ws/install/socialnav:/opt/ros/humble'),
    ],
)
def test_what_breaks_the_wheels_is_taken_out_of_the_environment(name, value):
    assert shell(SHOW.format('route.bash', name), **{name: value}).stdout == 'wheels,unset\n'


def test_what_is_taken_out_is_named_unless_it_is_ours():
    ours = f'{ROOT}/ros_ws/install/socialnav'
    result = shell(
        SHOW.format('route.bash', 'IGNORED'), RMW_IMPLEMENTATION='other', AMENT_PREFIX_PATH=ours
    )
    assert result.stdout == 'wheels, RMW_IMPLEMENTATION\n'


def test_the_tools_of_conda_are_not_taken():
    path = '/opt/conda/envs/robot/bin:/usr/bin:/opt/conda/envs/robot/condabin:/bin'
    result = shell(
        SHOW.format('route.bash', 'PATH'), PATH=path, CONDA_PREFIX='/opt/conda/envs/robot'
    )
    assert result.stdout == 'wheels,/usr/bin:/bin\n'


def test_what_is_run_stays_on_this_machine_and_in_no_domain_that_was_set():
    show = SHOW.format('environment.bash', 'ROS_DOMAIN_ID')
    show += '; echo $ROS_AUTOMATIC_DISCOVERY_RANGE'
    result = shell(show, ROS_DOMAIN_ID='7', ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET')
    assert result.stdout == 'wheels,unset\nLOCALHOST\n'


@pytest.mark.parametrize(('option', 'answer'), [('-s', 'Darwin'), ('-m', 'aarch64')])
def test_a_machine_without_wheels_is_told_in_one_line_what_to_use(tmp_path, option, answer):
    uname = tmp_path / 'uname'
    uname.write_text(
        f'#!/bin/sh\n[ "$1" = {option} ] && echo {answer} || exec /usr/bin/uname "$@"\n'
    )
    uname.chmod(0o755)
    result = shell('scripts/setup.sh', PATH=f'{tmp_path}:/usr/bin:/bin')
    assert result.returncode == 1
    assert answer in result.stderr
    assert 'Ubuntu 24.04' in result.stderr
    assert result.stderr.count('\n') == 1


def test_without_permission_to_install_the_line_to_type_is_printed(tmp_path):
    for folder in ('requirements', 'scripts'):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    for name in (
        'setup.py', 'studies/founding_report/setup.py', 'ros_ws/wheels/install_setup_files.py',
    ):  # fmt: skip
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    tools = tmp_path / 'tools'
    tools.mkdir()
    for name in ('bash', 'cat', 'cut', 'dirname', 'flock', 'make', 'sha256sum', 'tr', 'uname'):
        (tools / name).symlink_to(shutil.which(name))
    (tools / 'python3').symlink_to(Path(sys.executable).resolve())
    for name, answer in (('id', 'echo 1000'), ('apt-get', 'exit 9'), ('cmake', 'exit 9')):
        (tools / name).write_text(f'#!/bin/sh\n{answer}\n')
        (tools / name).chmod(0o755)
    result = shell(f'{tmp_path}/scripts/setup.sh', PATH=str(tools))
    assert result.returncode == 1
    assert result.stderr.count('\n') == 1
    assert 'sudo apt-get install -y g++' in result.stderr
    assert not (tmp_path / '.venv').exists()
