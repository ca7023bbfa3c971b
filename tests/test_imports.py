"""Laws of the directions of dependencies."""

import ast
from pathlib import Path
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / 'socialnav_core'
PARTS_BUILT_ON_THEM = (
    'simulation', 'sensing', 'policies', 'training', 'evaluation', 'reproduction',
)  # fmt: skip
FORBIDDEN = {
    'states.py': PARTS_BUILT_ON_THEM,
    'config.py': PARTS_BUILT_ON_THEM,
    'settings.py': PARTS_BUILT_ON_THEM,
    'simulation': (
        'sensing',
        'policies',
        'training',
        'evaluation',
        'reproduction',
        'cli',
        'commands',
    ),
    'sensing': ('policies', 'training', 'evaluation', 'reproduction', 'cli', 'commands'),
    'policies': ('training', 'evaluation', 'reproduction', 'cli', 'commands'),
    'training': ('evaluation', 'reproduction', 'cli', 'commands'),
    'evaluation': ('training', 'reproduction', 'cli', 'commands'),
    'benchmarking': ('reproduction', 'cli', 'commands'),
    'reproduction': ('cli', 'commands'),
}
"""What a part must not import from socialnav_core."""


def imported_modules(path):
    """Yield the names of the modules that a file imports anywhere."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f'{node.module}.{alias.name}' for alias in node.names)


def files_of(part):
    files = [PACKAGE / part] if part.endswith('.py') else sorted((PACKAGE / part).rglob('*.py'))
    assert files
    return files


@pytest.mark.parametrize('part', FORBIDDEN)
def test_a_part_does_not_import_what_is_built_on_it(part):
    for path in files_of(part):
        for module in imported_modules(path):
            for other in FORBIDDEN[part]:
                assert not f'{module}.'.startswith(f'socialnav_core.{other}.'), (path, module)


def test_matplotlib_is_imported_by_the_pictures_only():
    users = {
        path.relative_to(PACKAGE).as_posix()
        for path in PACKAGE.rglob('*.py')
        if any(module.startswith('matplotlib') for module in imported_modules(path))
    }
    assert users
    assert all(user.startswith('evaluation/') for user in users)
    assert not users & {'evaluation/metrics.py', 'evaluation/evaluate.py', 'evaluation/report.py'}


def test_the_core_never_imports_ros():
    for path in PACKAGE.rglob('*.py'):
        for module in imported_modules(path):
            assert module.split('.')[0] not in ('rclpy', 'geometry_msgs', 'socialnav_msgs'), path


def test_policies_load_without_pictures_ros_or_training():
    code = (
        'import sys, socialnav_core.policies; '
        "heavy = {'matplotlib', 'rclpy', 'tensorboard', 'socialnav_core.training', "
        "'socialnav_core.evaluation'} & set(sys.modules); sys.exit(str(heavy) if heavy else 0)"
    )
    run = subprocess.run([sys.executable, '-c', code], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
