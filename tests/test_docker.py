"""Laws of the container files: what they name exists, and the containers hear only each other."""

import ast
from pathlib import Path
import re

import pytest
import yaml

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / 'ros_ws' / 'src' / 'socialnav'
SERVICES = yaml.safe_load((ROOT / 'docker' / 'compose.yaml').read_text())['services']
DOCKERFILE = (ROOT / 'docker' / 'Dockerfile').read_text()


def parameters_of(name):
    """Return the names of the parameters of a node."""
    tree = ast.parse((PACKAGE / 'socialnav' / 'parameters' / f'{name}.py').read_text())
    (kind,) = (one for one in tree.body if isinstance(one, ast.ClassDef))
    return {one.target.id for one in kind.body if isinstance(one, ast.AnnAssign)}


@pytest.mark.parametrize(
    ('service', 'name'),
    [('simulator', 'simulator'), ('policy', 'policy'), ('sensing', 'simulator')],
)
def test_a_service_runs_a_node_with_parameters_that_it_has(service, name):
    executable, *arguments = SERVICES[service]['command']
    assert executable == f'{name}_node'
    assert f"'{executable} = socialnav." in (PACKAGE / 'setup.py').read_text()
    parameters = {one.split(':=')[0] for one in arguments if ':=' in one}
    assert parameters
    assert parameters <= parameters_of(name)


def test_nav2_is_launched_by_a_file_with_arguments_that_it_has_and_only_when_it_is_asked_for():
    *command, file, argument = SERVICES['nav2']['command']
    assert command == ['ros2', 'launch', 'socialnav']
    text = (PACKAGE / 'launch' / file).read_text()
    assert f"('{argument.split(':=')[0]}', " in text
    image = (ROOT / SERVICES['nav2']['build']['dockerfile']).read_text()
    packages = re.findall(r"'(nav2_[a-z_]+)'", text)
    assert 'nav2_planner' in packages
    for package in packages:
        assert f'ros-jazzy-{package.replace("_", "-")}' in image or package.endswith('launch')
    assert SERVICES['nav2']['profiles'] == SERVICES['sensing']['profiles'] == ['nav2']
    assert 'profiles' not in SERVICES['policy']


@pytest.mark.parametrize(('heard', 'hearing'), [('simulator', 'policy'), ('sensing', 'nav2')])
def test_the_policy_hears_the_simulator_and_nobody_else_does(heard, hearing):
    simulator, policy = SERVICES[heard], SERVICES[hearing]
    assert policy['network_mode'] == policy['ipc'] == f'service:{heard}'
    assert simulator['ipc'] == 'shareable'
    assert not {'network_mode', 'ports'} & simulator.keys()
    for service in (simulator, policy):
        assert service['environment']['ROS_AUTOMATIC_DISCOVERY_RANGE'] == 'LOCALHOST'
    assert simulator['environment'] == policy['environment']


def test_what_is_copied_into_the_image_is_there_and_not_ignored():
    sources = re.findall(r'^COPY (?!--from)(.*) \S+$', DOCKERFILE, re.MULTILINE)
    files = {name for line in sources for name in line.split()} - {'.'}
    assert 'docker/entrypoint.sh' in files
    ignored = (ROOT / '.dockerignore').read_text().splitlines()
    for name in files:
        assert (ROOT / name).is_file()
        assert f'!{name}' in ignored or f'!{name.split("/")[0]}' in ignored
    assert {'!socialnav_core', '!ros_ws', '!models', '!setup.py', '!package.xml'} <= set(ignored)


def test_the_image_runs_as_a_user_who_can_write_the_cache_of_kernels():
    last_stage = DOCKERFILE.split('\nFROM ')[-1]
    user = re.search(r'^USER (\d+)$', last_stage, re.MULTILINE).group(1)
    assert f'useradd --create-home --uid {user} socialnav' in last_stage
    folder = re.search(r'NUMBA_CACHE_DIR=(\S+)', last_stage).group(1)
    assert f'install -d -o socialnav {folder}' in last_stage
    assert all(f'cache:{folder}' in service['volumes'] for service in SERVICES.values())


def test_the_entry_point_is_executable_and_ends_as_the_command():
    path = ROOT / 'docker' / 'entrypoint.sh'
    assert path.stat().st_mode & 0o111 == 0o111
    assert path.read_text().endswith('exec "$@"\n')
