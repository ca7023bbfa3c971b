"""Laws of the installed package: it needs no checkout, and writes nothing into its folder."""

from importlib.metadata import Distribution, distribution
import json
import os
from pathlib import Path
import re
import shutil
import subprocess
import sys
import tarfile

from packaging.requirements import Requirement
import pytest
from sources import copy_sources

from socialnav_core import __version__

ROOT = Path(__file__).parents[1]
INTERPRETERS = ('3.11', '3.12')
TINY = (
    'scenario.pedestrians=2', 'scenario.obstacles=1', 'scenario.time_limit=15',
    'training.worlds=4', 'training.iterations=2', 'training.steps_per_iteration=4',
    'training.updates_per_iteration=1', 'training.batch_size=8', 'training.replay_capacity=200',
    'training.imitation.episodes=4', 'training.imitation.epochs=1',
)  # fmt: skip


class Installation:
    """A virtual environment with socialnav_core, and an empty folder to work in."""

    def __init__(self, environment: Path, folder: Path):
        self.environment, self.folder = environment, folder
        self.package = next(environment.glob('lib/python*/site-packages')) / 'socialnav_core'
        self.files = self.contents()

    def contents(self):
        return sorted(self.package.rglob('*'))

    def run(self, program, *words, code=0):
        """Run a program of the environment for a user who has nothing yet; return its output."""
        done = subprocess.run(
            [self.environment / 'bin' / program, *words], cwd=self.folder, text=True,
            env={'PATH': '/usr/bin:/bin', 'HOME': str(self.folder / 'home')},
            capture_output=True, timeout=280,
        )  # fmt: skip
        assert done.returncode == code, done.stdout + done.stderr
        assert self.contents() == self.files
        return done.stdout + done.stderr


def python(*words, folder=None):
    subprocess.run([sys.executable, *words], cwd=folder, check=True, capture_output=True)


def build_wheel(folder):
    """Build a wheel the way `python -m build` does, by way of the source archive."""
    build = 'from setuptools import build_meta; build_meta.build_{}({!r})'
    python('-c', build.format('sdist', str(folder)), folder=copy_sources(folder / 'sources'))
    [archive] = folder.glob('*.tar.gz')
    with tarfile.open(archive) as file:
        file.extractall(folder, filter='data')
    unpacked = folder / archive.name.removesuffix('.tar.gz')
    python('-c', build.format('wheel', str(folder)), folder=unpacked)
    return next(folder.glob('*.whl'))


def required(found):
    """Return the distributions that one requires without extras, directly or not, by name."""
    needed, waiting = {}, [found]
    while waiting:
        for text in waiting.pop().requires or ():
            requirement = Requirement(text)
            if requirement.marker and not requirement.marker.evaluate({'extra': ''}):
                continue
            if requirement.name not in needed:
                needed[requirement.name] = distribution(requirement.name)
                waiting.append(needed[requirement.name])
    return needed


def link(found, site):
    """Let another environment of the same Python see a distribution of this one."""
    for name in {file.parts[0] for file in found.files or ()} - {'..', '__pycache__'}:
        if not (site / name).exists():
            (site / name).symlink_to(found.locate_file(name))


@pytest.fixture(scope='module')
def installation(tmp_path_factory):
    """Return the wheel in an environment that else has what it requires, and no more."""
    folder = tmp_path_factory.mktemp('installation')
    environment = folder / 'environment'
    python('-m', 'venv', '--without-pip', environment)
    wheel = build_wheel(folder)
    target = environment / 'bin' / 'python'
    python('-m', 'pip', '--python', target, 'install', '-q', '--no-deps', '--no-index', wheel)
    site = next(environment.glob('lib/python*/site-packages'))
    [metadata] = site.glob('socialnav_core-*.dist-info')
    for found in required(Distribution.at(metadata)).values():
        link(found, site)
    for path in (site / 'socialnav_core').rglob('*'):
        path.chmod(0o555 if path.is_dir() else 0o444)
    work = folder / 'elsewhere'
    (work / 'home').mkdir(parents=True)
    yield Installation(environment, work)
    shutil.rmtree(folder, ignore_errors=True)


def test_the_command_says_its_version(installation):
    assert installation.run('socialnav', '--version') == f'socialnav {__version__}\n'


def test_the_shipped_models_and_the_scenarios_come_with_it(installation):
    listing = installation.run('socialnav', 'models')
    for weights in ROOT.glob('models/*/weights.safetensors'):
        assert f'{weights.parent.name} ' in listing
    assert 'damaged' not in listing
    assert 'hard' in installation.run('socialnav', 'scenarios')
    predictor = 'from socialnav_core.prediction.learned.checkpoint import load_predictor as load'
    installation.run('python', '-c', f'{predictor}; load()')


def test_the_study_is_not_part_of_it(installation):
    assert 'reproduce' not in installation.run('socialnav', '--help')


def test_a_shipped_model_is_evaluated(installation):
    words = ('gat4sn', '--scenario', 'hard', '--episodes', '20', '--json', 'result.json')
    assert 'gat4sn in hard: 20 cases' in installation.run('socialnav', 'evaluate', *words)
    result = json.loads((installation.folder / 'result.json').read_text())
    assert result['success_rate'] > 0.8


def test_the_card_of_an_installed_model_stays_as_it_is(installation):
    assert 'copy it' in installation.run('socialnav', 'models', '--cards', code=2)


def test_a_model_is_trained_and_what_is_missing_names_its_extra(installation):
    output = installation.run('socialnav', 'train', 'sarl', '--set', *TINY, '--out', 'new')
    assert "pip install 'socialnav_core[train]'" in output
    assert (installation.folder / 'new' / 'weights.safetensors').is_file()


def test_an_episode_is_drawn_and_a_bag_names_its_extra(installation):
    words = ('render', 'straight_line', '--scenario', 'circle')
    assert 'out/render' in installation.run('socialnav', *words)
    output = installation.run('socialnav', *words, '--bag', 'episode.mcap', code=1)
    assert output.count('\n') == 1
    assert "pip install 'socialnav_core[bag]'" in output


def test_a_report_is_written_with_all_its_parts(installation):
    words = ('straight_line', '--scenario', 'circle', '--episodes', '2', '--out', 'report')
    assert 'report/index.html' in installation.run('socialnav', 'report', *words)
    assert '<canvas' in (installation.folder / 'report' / 'index.html').read_text()


def test_the_example_of_the_readme_runs(installation):
    code = re.search('```python\n(.*?)```', (ROOT / 'README.md').read_text(), re.DOTALL)[1]
    for number, smaller in (('batch_size=64', 'batch_size=2'), ('episodes=500', 'episodes=2')):
        assert number in code
        code = code.replace(number, smaller)
    assert 0 <= float(installation.run('python', '-c', code)) <= 1


def interpreter(version):
    """Return a Python of this machine that can make environments; skip the test without one."""
    candidates = [
        shutil.which(f'python{version}'),
        *sorted(Path.home().glob(f'.pyenv/versions/{version}.*/bin/python{version}')),
    ]
    for candidate in filter(None, candidates):
        done = subprocess.run([candidate, '-c', 'import ensurepip'], capture_output=True)
        if done.returncode == 0:
            return candidate
    return pytest.skip(f'there is no Python {version} with ensurepip on this machine')


@pytest.mark.slow
@pytest.mark.timeout(1800)
@pytest.mark.parametrize('version', INTERPRETERS)
def test_pip_installs_it_with_everything_that_it_needs(version, tmp_path):
    environment, work = tmp_path / 'environment', tmp_path / 'elsewhere'
    (work / 'home').mkdir(parents=True)
    sources = copy_sources(tmp_path / 'sources')
    subprocess.run([interpreter(version), '-m', 'venv', environment], check=True)
    kept = {name: value for name, value in os.environ.items() if name != 'PYTHONPATH'}
    subprocess.run([environment / 'bin/pip', 'install', '-q', sources], check=True, env=kept)
    try:
        run = Installation(environment, work).run
        assert __version__ in run('socialnav', '--version')
        words = ('gat4sn', '--scenario', 'hard', '--episodes', '20')
        assert 'gat4sn in hard: 20 cases' in run('socialnav', 'evaluate', *words)
        run('socialnav', 'train', 'sarl', '--set', *TINY, '--out', 'new')
    finally:
        shutil.rmtree(environment)  # gigabytes
