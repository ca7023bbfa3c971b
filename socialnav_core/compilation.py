"""Compilation of kernels by numba, cached on disk until any source of the package changes."""

from collections.abc import Callable
import contextlib
import functools
import hashlib
import os
from pathlib import Path
from typing import Any
import warnings

import numba

from socialnav_core.places import CHECKOUT, PACKAGE


def compiled(function: Callable[..., Any]) -> Any:
    """
    Compile a function when it is first called, without the interpreter's lock.

    numba by itself takes code from its cache as long as the function's own file is the same, even
    when a function that it calls, from another file, has changed. Here the cache is another one
    for every state of the sources, and the same whether these are reached directly or through the
    links of a workspace.

    :param function: of numbers and arrays.
    """
    code = function.__code__
    function.__code__ = code.replace(co_filename=os.path.realpath(code.co_filename))
    settings: Any = numba.config
    before = settings.CACHE_DIR
    settings.CACHE_DIR = str(cache_folder())
    try:
        return numba.njit(cache=cache_is_writable(), nogil=True, error_model='numpy')(function)
    finally:
        settings.CACHE_DIR = before


inlined = numba.njit(nogil=True, error_model='numpy', forceinline=True)
"""
Compiles a function into whatever calls it: where arrays are passed in inner loops, since numba
counts references to the arrays of every call.
"""


@functools.cache
def cache_is_writable() -> bool:
    """Return whether compiled code can be kept; warn where not, since that costs a minute."""
    folder = cache_folder()
    with contextlib.suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
    writable = os.access(folder, os.W_OK)
    if not writable:
        warnings.warn(
            f'{folder} cannot be written, so kernels are compiled anew in every process: '
            'let NUMBA_CACHE_DIR name another folder', stacklevel=2,
        )  # fmt: skip
    return writable


@functools.cache
def cache_folder() -> Path:
    """Return where compiled code is kept: beside a checkout's sources, or in the user's cache."""
    if os.environ.get('NUMBA_CACHE_DIR'):
        return Path(os.environ['NUMBA_CACHE_DIR']) / sources_digest()
    if CHECKOUT is not None and os.access(PACKAGE, os.W_OK):
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
