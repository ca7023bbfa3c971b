"""One training in a folder at a time."""

from collections.abc import Iterator
import contextlib
import fcntl
import os
from pathlib import Path
import sys

from socialnav_core.config import ConfigError


@contextlib.contextmanager
def locked(folder: Path) -> Iterator[None]:
    """
    Keep a folder for this training; the system lets it go however the process ends.

    The folder itself is locked: no file is left behind that could be taken for a lock.

    :raises ConfigError: when another training has it.
    """
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        os.close(descriptor)
        raise ConfigError(
            f'{folder} is in use by another training; wait for it or choose another --out'
        ) from error
    except OSError as error:  # some network file systems lock no folders
        print(f'{folder} cannot be locked ({error.strerror}): start no other training in it',
              file=sys.stderr)  # fmt: skip
    try:
        yield
    finally:
        with contextlib.suppress(OSError):
            os.close(descriptor)
