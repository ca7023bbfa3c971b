"""Laws of the directions of dependencies among the wings of the package."""

import ast
from pathlib import Path
import subprocess
import sys

import pytest

PACKAGE = Path(__file__).parents[1] / 'socialnav'
GROUND = {'qos', 'parameters', 'programs'}
"""Modules of the top level that wings may use; the others, which use the wings, they may not."""
USES: dict[str, set[str]] = {
    'messages': set(),
    'control': {'messages'},
    'realtime': {'messages', 'control'},
    'perception': {'messages'},
    'simulator': {'messages'},
    'demo': {'messages', 'control'},
}
"""What each wing may import of the others."""
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


@pytest.mark.parametrize('wing', USES)
def test_a_wing_imports_what_it_is_built_on_and_nothing_else(wing):
    files = list((PACKAGE / wing).rglob('*.py'))
    assert len(files) > 1
    for path in files:
        assert imported_parts(path) <= USES[wing] | GROUND | {wing}, path


def test_the_ground_imports_no_wing():
    for name in GROUND:
        assert not imported_parts(PACKAGE / f'{name}.py') & USES.keys(), name


def test_every_wing_has_its_place_and_the_top_level_stays_small():
    assert {path.parent.name for path in PACKAGE.glob('*/__init__.py')} == USES.keys()
    assert len(list(PACKAGE.glob('*.py'))) <= LARGEST_TOP_LEVEL


def test_decisions_are_made_without_rclpy():
    modules = [
        f'socialnav.control.{path.stem}' for path in (PACKAGE / 'control').glob('[a-z]*.py')
    ]
    code = f'import sys, {", ".join(modules)}; sys.exit("rclpy" in sys.modules)'
    run = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr or 'rclpy has been loaded'
