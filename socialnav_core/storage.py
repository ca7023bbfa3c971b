"""Files that are written whole or not at all, and the digest of the arrays in them."""

from collections.abc import Iterator, Mapping
import contextlib
import hashlib
import json
import os
from pathlib import Path

import numpy as np

UNREADABLE = (OSError, ValueError, TypeError, KeyError, RuntimeError, MemoryError, OverflowError)
"""What reading a file of weights raises where its header tells nonsense."""
LARGEST_WEIGHT = 1e4
"""Trained weights stay below ten."""
LARGEST_FILE = 2**28
"""Weights take no more bytes than this."""


class CheckpointError(ValueError):
    """A checkpoint that is missing, damaged or of something else."""


def arrays_digest(arrays: Mapping[str, np.ndarray]) -> str:
    """Return the SHA-256 of arrays and their names, hexadecimal."""
    digest = hashlib.sha256()
    for name in sorted(arrays):
        digest.update(name.encode())
        digest.update(arrays[name].tobytes())
    return digest.hexdigest()


def require_sane(arrays: Mapping[str, np.ndarray], path: Path) -> None:
    """
    Raise a CheckpointError unless all weights are numbers that a training could have led to.

    :param path: of the weights, for the message.
    """
    for name, array in arrays.items():
        if not np.isfinite(array).all():
            raise CheckpointError(f'{path} holds values that are not finite, in {name}')
        if array.size and np.abs(array).max() > LARGEST_WEIGHT:
            raise CheckpointError(f'{path} holds weights above {LARGEST_WEIGHT:g}, in {name}')


def require_weights_file(path: Path) -> None:
    """
    Raise a CheckpointError unless a file is there that may hold weights.

    A device or a pipe might never end, and a network of this package is small.
    """
    if not path.is_file():
        raise CheckpointError(f'{path} cannot be read as weights: there is no such file')
    if path.stat().st_size > LARGEST_FILE:
        raise CheckpointError(f'{path} is larger than {LARGEST_FILE >> 20} MiB: no weights')


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
        with named_errors(path, temporary):
            yield temporary
            temporary.replace(path)
    finally:
        with contextlib.suppress(OSError):  # where nothing could be written, nothing is there
            temporary.unlink(missing_ok=True)


@contextlib.contextmanager
def named_errors(path: Path | str, temporary: Path | None = None) -> Iterator[None]:
    """
    Let an error of the system that names no file, such as a full disk, name the one written to.

    :param temporary: stands in for the file: an error that names it names the file instead.
    """
    try:
        yield
    except OSError as error:
        if error.errno is None or error.filename not in (None, str(temporary)):
            raise
        raise OSError(error.errno, error.strerror, str(path)) from error


def canonical(data: bytes) -> bytes:
    """
    Return a safetensors file with its header in one order, so that equal contents are equal bytes.

    The library writes the metadata in an order that chance decides.

    :param data: a file, as `safetensors` makes it.
    """
    length = int.from_bytes(data[:8], 'little')
    header = json.loads(data[8 : 8 + length])
    metadata = header.pop('__metadata__', {})
    tensors = sorted(header.items(), key=lambda item: (item[1]['data_offsets'], item[0]))
    ordered = {'__metadata__': dict(sorted(metadata.items())), **dict(tensors)}
    text = json.dumps(ordered, separators=(',', ':')).encode()
    text += b' ' * (-len(text) % 8)  # the format aligns the data by spaces
    return len(text).to_bytes(8, 'little') + text + data[8 + length :]
