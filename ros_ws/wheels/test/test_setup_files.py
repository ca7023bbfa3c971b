"""Laws of the files that make the virtual environment an underlay."""

import os
from pathlib import Path
import subprocess
import sys

from graph_under_test import ISOLATION, WORKSPACE
from install_setup_files import setup_script
import pytest

WHEELS = WORKSPACE / 'wheels'
ENVIRONMENT = WORKSPACE.parent / '.venv'
WHEEL_ROUTE = (ENVIRONMENT / 'setup.bash').exists()
needs_wheels = pytest.mark.skipif(not WHEEL_ROUTE, reason='ROS 2 is not from wheels here')
NAMES = ('AMENT_PREFIX_PATH', 'CMAKE_PREFIX_PATH', 'PATH', 'LD_LIBRARY_PATH')
SHOW = '; '.join(f'echo "${name}"' for name in NAMES)


def shell(command: str, name: str = 'bash', **variables: str) -> str:
    """Return what a shell prints that knows nothing but PATH, HOME and the given variables."""
    base = {'PATH': '/usr/bin:/bin', 'HOME': os.environ['HOME']}
    result = subprocess.run(
        [name, '-euc', command], capture_output=True, text=True, env=base | variables, timeout=120
    )
    assert result.returncode == 0, result.stderr
    return result.stdout


@pytest.fixture
def environment(tmp_path: Path) -> Path:
    """Return an environment with a setup file; its name has a space and a quote."""
    environment = tmp_path / "somebody's environment"
    site_packages = environment / 'lib' / 'site-packages'
    for name in ('ros_one.libs', 'ros_two.libs', 'other.libs'):
        (site_packages / name).mkdir(parents=True)
    (environment / 'setup.sh').write_text(setup_script(environment, site_packages))
    return environment


@pytest.mark.parametrize('name', ['bash', 'sh'])
def test_sourcing_puts_the_environment_in_front(environment: Path, name: str) -> None:
    source = f'. "{environment}/setup.sh"'
    ament, cmake, path, libraries = shell(f'{source}; {SHOW}', name, PATH='/bin').splitlines()
    assert ament == cmake == str(environment)
    assert path == f'{environment}/bin:/bin'
    packages = environment / 'lib' / 'site-packages'
    assert set(libraries.split(':')) == {
        f'{environment}/lib',
        f'{packages}/ros_one.libs',
        f'{packages}/ros_two.libs',
    }


@pytest.mark.parametrize('name', ['bash', 'sh'])
def test_sourcing_twice_is_sourcing_once(environment: Path, name: str) -> None:
    source = f'. "{environment}/setup.sh"'
    assert shell(f'{source}; {source}; env', name) == shell(f'{source}; env', name)


def test_a_profile_of_the_user_is_kept(environment: Path) -> None:
    command = f'. "{environment}/setup.sh"; echo $FASTRTPS_DEFAULT_PROFILES_FILE'
    assert shell(command, FASTRTPS_DEFAULT_PROFILES_FILE='/mine.xml') == '/mine.xml\n'
    assert Path(shell(command).strip()).is_file()


def test_a_folder_that_is_no_environment_of_this_python_is_refused(tmp_path: Path) -> None:
    command = [sys.executable, str(WHEELS / 'install_setup_files.py'), str(tmp_path)]
    result = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert result.returncode == 1
    assert 'must be the virtual environment of the Python that runs this' in result.stderr
    assert not any(tmp_path.iterdir())


@needs_wheels
@pytest.mark.parametrize('file', ['setup.bash', 'local_setup.bash', 'setup.sh', 'local_setup.sh'])
def test_each_file_is_enough_to_use_ros(file: str) -> None:
    command = f'. {ENVIRONMENT}/{file}; python -c "import rclpy; print(rclpy.ok())"; ros2 --help'
    text = shell(command, 'bash' if file.endswith('bash') else 'sh')
    assert text.startswith('False\nusage: ros2')
    assert 'small stand-in for ros2cli' in text


@needs_wheels
def test_colcon_finds_each_package_once_and_searches_nothing_else() -> None:
    text = shell(f'. {ENVIRONMENT}/setup.bash; cd {WORKSPACE}; colcon list')
    assert text.splitlines() == [
        'socialnav\tsrc/socialnav\t(ros.ament_python)',
        'socialnav_core\t..\t(ros.ament_python)',
        'socialnav_msgs\tsrc/socialnav_msgs\t(ros.ament_cmake)',
    ]


@needs_wheels
def test_sourcing_the_built_workspace_alone_is_enough_to_run_a_node() -> None:
    command = f"""
        set +u; . {WORKSPACE}/install/setup.bash
        timeout -k 5 100 ros2 run socialnav simulator_node & node=$!
        until ros2 topic echo --once /odom --field header.frame_id 2> /dev/null; do :; done
        kill $node; wait $node
    """
    assert shell(command, **ISOLATION) == 'odom\n---\n'
