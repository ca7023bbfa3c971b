"""Laws of the directions of dependencies among the wings of the package."""

import ast
from pathlib import Path
import subprocess
import sys

import pytest

PACKAGE = Path(__file__).parents[1] / 'socialnav'
ORDER = (
    'qos', 'programs', 'neighbours', 'messages', 'parameters', 'control', 'nav2', 'realtime',
    'perception', 'simulator', 'demo',
)  # fmt: skip
"""Wings, and modules that they use; none imports one that comes after it, or any other module."""
LARGEST_TOP_LEVEL = 15


def imported_parts(path):
    """Return which parts of the package a file imports anywhere."""
    parts = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [f'{node.module}.{alias.name}' for alias in node.names]
        else:
            continue
        parts |= {name.split('.')[1] for name in names if name.startswith('socialnav.')}
    return parts


def files_of(part):
    files = [PACKAGE / f'{part}.py', *sorted((PACKAGE / part).rglob('*.py'))]
    return [path for path in files if path.exists()]


@pytest.mark.parametrize('part', ORDER)
def test_a_wing_imports_what_it_is_built_on_and_nothing_else(part):
    assert files_of(part)
    for path in files_of(part):
        assert imported_parts(path) <= set(ORDER[: ORDER.index(part) + 1]), path


def test_every_wing_has_its_place_and_the_top_level_stays_small():
    assert {path.parent.name for path in PACKAGE.glob('*/__init__.py')} <= set(ORDER)
    assert len(list(PACKAGE.glob('*.py'))) <= LARGEST_TOP_LEVEL


def test_decisions_are_made_without_rclpy():
    modules = [
        f'socialnav.control.{path.stem}' for path in (PACKAGE / 'control').glob('[a-z]*.py')
    ]
    code = f'import sys, {", ".join(modules)}; sys.exit("rclpy" in sys.modules)'
    run = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr or 'rclpy has been loaded'
