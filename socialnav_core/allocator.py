"""glibc's memory allocator, told to keep what is freed, or to give back what is large."""

import ctypes
import functools
import sys

M_TRIM_THRESHOLD, M_TOP_PAD, M_MMAP_THRESHOLD = -1, -2, -3
LARGE, KEPT = 2**22, 2**24
"""Blocks of so many bytes are given back one by one; so many at the end of the heap stay there."""


@functools.cache
def keep_freed_memory() -> None:
    """
    Let freed memory stay with the process, which halves the time of large network batches.

    By default glibc hands blocks of some hundred kilobytes back to the system at once and gets
    them again, zeroed page by page, for the next layer. Elsewhere than on glibc nothing happens.
    """
    set_options({M_MMAP_THRESHOLD: 2**30, M_TRIM_THRESHOLD: 2**31 - 1, M_TOP_PAD: 2**26})


def give_back_large_blocks() -> None:
    """
    Let freed blocks of four megabytes and more go back to the system, whatever lies beside them.

    By default glibc takes blocks of up to 32 megabytes from its heap once one of that size has
    been freed. A heap shrinks from its end only: what is small and lies there keeps all that is
    below. Elsewhere than on glibc nothing happens.
    """
    set_options({M_MMAP_THRESHOLD: LARGE, M_TRIM_THRESHOLD: KEPT})


def set_options(values: dict[int, int]) -> None:
    """Set options of glibc's allocator; do nothing elsewhere."""
    if not sys.platform.startswith('linux'):
        return
    mallopt = getattr(ctypes.CDLL(None), 'mallopt', None)
    if mallopt is not None:
        for option, value in values.items():
            mallopt(option, value)
