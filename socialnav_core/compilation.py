"""Compilation of kernels by numba, cached on disk until any source of the package changes."""

from collections.abc import Callable
import functools
import hashlib
import os
from pathlib import Path
from typing import Any

import numba

PACKAGE = Path(__file__).parent


def compiled(function: Callable[..., Any]) -> Any:
    """
    Compile a function when it is first called, without the interpreter's lock.

    numba by itself takes code from its cache as long as the function's own file is the same, even
    when a function that it calls, from another file, has changed. Here the cache is another one
    for every state of the sources.

    :param function: of numbers and arrays.
    """
    settings: Any = numba.config
    before = settings.CACHE_DIR
    settings.CACHE_DIR = str(cache_folder())
    try:
        return numba.njit(cache=True, nogil=True, error_model='numpy')(function)
    finally:
        settings.CACHE_DIR = before


inlined = numba.njit(nogil=True, error_model='numpy', forceinline=True)
"""
Compiles a function into whatever calls it: where arrays are passed in inner loops, since numba
counts references to the arrays of every call.
"""


@functools.cache
def cache_folder() -> Path:
    """Return where compiled code is kept: beside the sources, or in the user's cache."""
    if os.environ.get('NUMBA_CACHE_DIR'):
        return Path(os.environ['NUMBA_CACHE_DIR']) / sources_digest()
    if os.access(PACKAGE, os.W_OK):
        return PACKAGE / '__pycache__' / 'kernels' / sources_digest()
    user = os.environ.get('XDG_CACHE_HOME') or Path.home() / '.cache'
    return Path(user) / 'socialnav' / 'kernels' / sources_digest()


def sources_digest() -> str:
    """Return the digest of all files of the package that hold kernels."""
    digest = hashlib.sha256()
    for path in sorted(PACKAGE.rglob('*.py')):
        text = path.read_bytes()
        if b'@compiled' in text or b'@inlined' in text:
            digest.update(path.relative_to(PACKAGE).as_posix().encode() + text)
    return digest.hexdigest()[:16]
