"""Files that are written whole or not at all, and the digest of the arrays in them."""

from collections.abc import Iterator, Mapping
import contextlib
import hashlib
import os
from pathlib import Path

import numpy as np


class CheckpointError(ValueError):
    """A checkpoint that is missing, damaged or of something else."""


def arrays_digest(arrays: Mapping[str, np.ndarray]) -> str:
    """Return the SHA-256 of arrays and their names, hexadecimal."""
    digest = hashlib.sha256()
    for name in sorted(arrays):
        digest.update(name.encode())
        digest.update(arrays[name].tobytes())
    return digest.hexdigest()


def atomic_write(path: Path, data: bytes) -> None:
    """Write a file so that a reader, or a crash, sees the old content or the new, never a part."""
    with written_whole(path) as temporary, temporary.open('wb') as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


@contextlib.contextmanager
def written_whole(path: Path) -> Iterator[Path]:
    """Give a file to write to that replaces another when it is complete, else is removed."""
    temporary = path.with_name(f'.{path.stem}.{os.getpid()}{path.suffix}')
    try:
        yield temporary
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
