"""Laws of glibc's memory allocator as it is set here."""

import subprocess
import sys

import pytest

PROGRAM = """
import ctypes, sys
from pathlib import Path
from socialnav_core.allocator import give_back_large_blocks
libc = ctypes.CDLL(None)
libc.malloc.restype, libc.malloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
libc.free.argtypes = [ctypes.c_void_p]
libc.memset.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_size_t]
def resident():
    return int(Path('/proc/self/statm').read_text().split()[1]) * 4096
def block(size):
    address = libc.malloc(size)
    libc.memset(address, 1, size)
    return address
if sys.argv[1] == 'set':
    give_back_large_blocks()
libc.free(block(30 * 2**20))  # after which blocks of this size come from the heap
before = resident()
large, small = block(20 * 2**20), [block(1000) for _ in range(100)]
libc.free(large)
print((resident() - before) / 2**20)
"""


@pytest.mark.skipif(not sys.platform.startswith('linux'), reason='glibc')
def test_a_large_block_goes_back_to_the_system_whatever_lies_beside_it():
    kept = {
        how: float(
            subprocess.run(
                [sys.executable, '-c', PROGRAM, how], capture_output=True, text=True, check=True
            ).stdout
        )
        for how in ('unset', 'set')
    }
    assert kept['set'] < 1.0 < 19.0 < kept['unset']
