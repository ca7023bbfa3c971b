"""Laws of packaging: what pip and colcon make of the sources."""

from pathlib import Path
import re
import shutil
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[1]
WORKSPACE = ('colcon_defaults.yaml', 'src')
PACKAGES = {'socialnav', 'socialnav_core', 'socialnav_msgs'}


def run(*command, folder, **variables):
    """Run a command in a bare environment; return what it prints."""
    environment = {'PATH': '/usr/bin:/bin', 'HOME': str(folder)} | variables
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def bash(script, folder):
    return run('bash', '-ec', script, folder=folder)


def copy_of_the_sources(folder):
    """Copy what colcon builds; the folder is the copy's root."""
    for name in ('setup.py', 'package.xml', 'ros_ws/colcon_defaults.yaml'):
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    for name in ('socialnav_core', 'models', 'ros_ws/src'):
        if (ROOT / name).exists():
            ignored = shutil.ignore_patterns('__pycache__', '*.safetensors')
            shutil.copytree(ROOT / name, folder / name, ignore=ignored)
    return folder


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
    root = copy_of_the_sources(tmp_path)
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
    assert 'usage: socialnav' in run(install / 'socialnav_core/bin/socialnav', '-h', folder=root)


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_what_plain_colcon_builds_runs_after_sourcing_the_install_folder_alone(tmp_path):
    root = copy_of_the_sources(tmp_path)
    for options in ((), ('--symlink-install',), ()):  # one after the other in the same folders
        install = colcon_build(root, *options)
        output = bash(f'source {install}/setup.bash; ros2 run socialnav demo --help', root)
        assert output.startswith('usage: demo')


def test_the_console_script_runs_in_any_folder(tmp_path):
    script = Path(sys.executable).parent / 'socialnav'
    assert 'usage: socialnav' in run(script, '--help', folder=tmp_path)


def test_all_packages_have_one_version():
    manifests = [ROOT / 'package.xml', *(ROOT / 'ros_ws' / 'src').glob('*/package.xml')]
    scripts = [ROOT / 'setup.py', *(ROOT / 'ros_ws' / 'src').glob('*/setup.py')]
    versions = [re.search('<version>(.*)</version>', file.read_text())[1] for file in manifests]
    versions += [re.search("version='(.*)'", file.read_text())[1] for file in scripts]
    assert len(manifests) == len(PACKAGES)
    assert len(set(versions)) == 1, versions


def test_every_requirement_is_pinned():
    for file in (ROOT / 'requirements').glob('*.txt'):
        for line in file.read_text().splitlines():
            assert line.startswith('#') or re.fullmatch(r'[\w.\[\]-]+==[\w.]+', line), (file, line)
