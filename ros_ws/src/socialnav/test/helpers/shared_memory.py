"""The files in /dev/shm by which nodes on one machine speak to each other."""

import contextlib
from pathlib import Path
import re
import subprocess

FOLDER = '/dev/shm/'
SEGMENT = re.compile('fastrtps_[0-9a-f]+_el')
"""The file that the owner of a segment holds open."""


def owned_files(process: subprocess.Popen) -> set[Path]:
    """Return the files of a node, which runs under a guard; none where it has ended."""
    children = Path(f'/proc/{process.pid}/task/{process.pid}/children')
    with contextlib.suppress(OSError):
        return {
            file
            for node in children.read_text().split()
            for lock in locks(node)
            for file in files_of(lock)
        }
    return set()


def locks(node: str) -> set[Path]:
    """Return the locks of the segments of a process; ports are used by others as well."""
    targets = set()
    for link in Path(f'/proc/{node}/fd').iterdir():
        with contextlib.suppress(OSError):  # closed in the meantime
            targets.add(link.readlink())
    return {one for one in targets if str(one).startswith(FOLDER) and SEGMENT.fullmatch(one.name)}


def files_of(lock: Path) -> list[Path]:
    """Return all files of a segment that is locked."""
    return [lock, lock.with_name(lock.name.removesuffix('_el'))]


def remove(files: set[Path]) -> None:
    """Remove what a node that was killed has left behind."""
    for file in files:
        file.unlink(missing_ok=True)
