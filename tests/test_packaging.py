"""Laws of packaging: what pip and colcon make of the sources."""

from distutils.core import run_setup
from pathlib import Path
import re
import subprocess
import sys

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
import pytest
from sources import copy_sources
import yaml

from socialnav_core import __version__

ROOT = Path(__file__).parents[1]
WORKSPACE = ('ros_ws/colcon_defaults.yaml', 'ros_ws/src')
PACKAGES = {'socialnav', 'socialnav_core', 'socialnav_msgs'}


def run(*command, folder, **variables):
    """Run a command in a bare environment; return what it prints."""
    environment = {'PATH': '/usr/bin:/bin', 'HOME': str(folder)} | variables
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def bash(script, folder):
    return run('bash', '-ec', script, folder=folder)


def colcon_build(root, *options):
    bash(f'source {ROOT}/.venv/setup.bash; cd ros_ws; colcon build {" ".join(options)}', root)
    return root / 'ros_ws' / 'install'


def place_of_the_core(install):
    """Return where Python finds socialnav_core once an install folder is sourced."""
    code = 'import socialnav_core.cli; print(socialnav_core.cli.__file__)'
    return Path(bash(f"source {install}/setup.bash; python3 -c '{code}'", install).strip())


def test_colcon_finds_every_package_of_the_workspace():
    listing = run(sys.executable, '-m', 'colcon', 'list', folder=ROOT / 'ros_ws')
    kinds = {line.split()[0]: line.split()[-1] for line in listing.splitlines()}
    assert set(kinds) == PACKAGES
    assert kinds['socialnav_core'] == kinds['socialnav'] == '(ros.ament_python)'


@pytest.mark.parametrize('options', [(), ('--symlink-install',)])
def test_colcon_installs_the_core_with_its_configurations(tmp_path, options):
    root = copy_sources(tmp_path, *WORKSPACE)
    install = colcon_build(root, *options, '--packages-select socialnav_core')
    place = place_of_the_core(install)
    assert place.is_relative_to(root if options else install)
    configurations = {
        path.name for path in (ROOT / 'socialnav_core' / 'config' / 'recipes').glob('*.yaml')
    }
    assert {
        path.name for path in (place.parent / 'config' / 'recipes').glob('*.yaml')
    } == configurations
    assert (place.parent / 'viewing' / 'ros2msg.txt').is_file()
    command = f'source {install}/setup.bash; cd /; socialnav'
    assert 'usage: socialnav' in bash(f'{command} -h', root)
    assert re.search('^gat4sn .* hard ', bash(f'{command} models', root), re.MULTILINE)


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_what_plain_colcon_builds_runs_after_sourcing_the_install_folder_alone(tmp_path):
    root = copy_sources(tmp_path, *WORKSPACE)
    for options in ((), ('--symlink-install',), ()):  # one after the other in the same folders
        install = colcon_build(root, *options)
        output = bash(f'source {install}/setup.bash; ros2 run socialnav demo --help', root)
        assert output.startswith('usage: demo')


def test_the_console_script_runs_in_any_folder(tmp_path):
    script = Path(sys.executable).parent / 'socialnav'
    assert 'usage: socialnav' in run(script, '--help', folder=tmp_path)


def test_everything_that_says_the_version_says_the_same():
    manifests = [ROOT / 'package.xml', *(ROOT / 'ros_ws' / 'src').glob('*/package.xml')]
    scripts = [*ROOT.glob('studies/*/setup.py'), *ROOT.glob('ros_ws/src/*/setup.py')]
    versions = [re.search('<version>(.*)</version>', file.read_text())[1] for file in manifests]
    versions += [re.search("version='(.*)'", file.read_text())[1] for file in scripts]
    citation = yaml.safe_load((ROOT / 'CITATION.cff').read_text())
    assert len(manifests) == len(PACKAGES)
    assert {*versions, citation['version'], metadata().get_version()} == {__version__}


def test_the_version_has_a_dated_entry_in_the_changelog():
    entry = f'## [{__version__}] - '
    [line] = [line for line in (ROOT / 'CHANGELOG.md').read_text().splitlines() if entry in line]
    citation = yaml.safe_load((ROOT / 'CITATION.cff').read_text())
    assert line == f'{entry}{citation["date-released"]}'


def test_there_is_one_address_to_write_to():
    address = metadata().get_maintainer_email()
    for name in ('package.xml', 'ros_ws/src/socialnav/setup.py', 'SECURITY.md'):
        assert address in (ROOT / name).read_text(), name


def metadata():
    """Return what setup.py declares."""
    return run_setup(str(ROOT / 'setup.py'), stop_after='init')


def pins():
    """Return the exact version of each package in requirements/."""
    lines = [
        line
        for file in (ROOT / 'requirements').glob('*.txt')
        for line in file.read_text().splitlines()
        if not line.startswith('#')
    ]
    found = [Requirement(line) for line in lines]
    assert all(re.fullmatch(r'[\w.\[\]-]+==[\w.]+', line) for line in lines), lines
    return {canonicalize_name(each.name): str(each.specifier)[2:] for each in found}


def test_every_requirement_is_pinned():
    assert len(pins()) > 20


def test_what_is_required_loosely_allows_what_is_pinned():
    declared = metadata()
    loose = [*declared.install_requires, *sum(declared.extras_require.values(), [])]
    exact = pins()
    for requirement in map(Requirement, loose):
        assert requirement.specifier.contains(exact[canonicalize_name(requirement.name)])


def test_torch_is_required_up_to_the_version_that_is_pinned():
    [torch] = [each for each in metadata().install_requires if each.startswith('torch')]
    major, minor, _ = pins()['torch'].split('.')
    assert not Requirement(torch).specifier.contains(f'{major}.{int(minor) + 1}.0')


def test_the_hooks_of_pre_commit_run_the_pinned_tools():
    hooks = yaml.safe_load((ROOT / '.pre-commit-config.yaml').read_text())['repos'][0]['hooks']
    exact = pins()
    for hook in hooks:
        for requirement in map(Requirement, hook['additional_dependencies']):
            assert requirement.specifier.contains(exact[canonicalize_name(requirement.name)])
