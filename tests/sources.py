"""Copies of the sources, so that building them leaves nothing in the checkout."""

from pathlib import Path
import shutil

ROOT = Path(__file__).parents[1]
FILES = ('LICENSE', 'MANIFEST.in', 'README.md', 'package.xml', 'pyproject.toml', 'setup.py')
FOLDERS = ('models', 'socialnav_core')


def copy_sources(folder: Path, *more: str) -> Path:
    """Copy what the core is built from, and more files or folders of the root, into a folder."""
    for name in (*FILES, *FOLDERS, *more):
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if (ROOT / name).is_file():
            shutil.copy(ROOT / name, target)
        else:
            shutil.copytree(ROOT / name, target, ignore=shutil.ignore_patterns('__pycache__'))
    return folder
