"""Laws of the directions of dependencies."""

import ast
from pathlib import Path
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / 'socialnav_core'
ORDER = (
    'states', 'storage', 'tables', 'config', 'simulation', 'metrics', 'sensing', 'messages',
    'prediction', 'policies', 'environments', 'training', 'evaluation', 'viewing',
    'benchmarking', 'commands', 'cli',
)  # fmt: skip
"""Parts of socialnav_core; none imports one that comes after it."""


def imported_modules(path):
    """Yield the names of the modules that a file imports anywhere."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f'{node.module}.{alias.name}' for alias in node.names)


def files_of(part):
    files = [PACKAGE / f'{part}.py', *sorted((PACKAGE / part).rglob('*.py'))]
    return [path for path in files if path.exists()]


@pytest.mark.parametrize('part', ORDER)
def test_a_part_does_not_import_what_is_built_on_it(part):
    above = ORDER[ORDER.index(part) + 1 :]
    assert files_of(part)
    for path in files_of(part):
        for module in imported_modules(path):
            for other in above:
                assert not f'{module}.'.startswith(f'socialnav_core.{other}.'), (path, module)


def test_every_part_has_its_place_in_the_order():
    folders = {path.parent.name for path in PACKAGE.glob('*/__init__.py')}
    assert folders <= set(ORDER)


def test_matplotlib_is_imported_in_viewing_only():
    users = {
        path.relative_to(PACKAGE).parts[0]
        for path in PACKAGE.rglob('*.py')
        if any(module.startswith('matplotlib') for module in imported_modules(path))
    }
    assert users == {'viewing'}


def test_the_core_never_imports_ros():
    for path in PACKAGE.rglob('*.py'):
        for module in imported_modules(path):
            assert module.split('.')[0] not in ('rclpy', 'geometry_msgs', 'socialnav_msgs'), path


def test_policies_load_without_pictures_ros_or_training():
    code = (
        'import sys, socialnav_core.policies; '
        "heavy = {'matplotlib', 'rclpy', 'tensorboard', 'socialnav_core.training', "
        "'socialnav_core.evaluation', 'socialnav_core.viewing'} & set(sys.modules); "
        'sys.exit(str(heavy) if heavy else 0)'
    )
    run = subprocess.run([sys.executable, '-c', code], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
