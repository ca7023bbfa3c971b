"""Counter-based random numbers: a draw is a function of its address (Philox, Salmon 2011)."""

import numpy as np

from socialnav_core.compilation import compiled

LAYOUT = 0
GOALS = 1
SPLITS = {'train': 0, 'validation': 1, 'test': 2}

_LOW = np.uint64(0xFFFFFFFF)
_SHIFT = np.uint64(32)
_MULTIPLIER_0 = np.uint64(0xD2511F53)
_MULTIPLIER_1 = np.uint64(0xCD9E8D57)
_WEYL_0 = np.uint64(0x9E3779B9)
_WEYL_1 = np.uint64(0xBB67AE85)


def stream(split: str, seed: int, case: int, purpose: int, index: int = 0) -> np.ndarray:
    """
    Return a random stream, uint64 (6,): two key words, then four counter words.

    :param split: train, validation or test.
    :param seed: 0 <= seed < 2 ** 64.
    :param case: number of the case, 0 <= case < 2 ** 32.
    :param purpose: LAYOUT or GOALS; streams of different purposes are independent.
    :param index: number within the purpose, such as that of a pedestrian.
    """
    words = (seed & 0xFFFFFFFF, seed >> 32, case, SPLITS[split] << 16 | purpose, index, 0)
    return np.array(words, dtype=np.uint64)


@compiled
def philox(stream):  # type: ignore[no-untyped-def]
    """
    Return the four 32-bit words of a stream's present counter, as uint64.

    :param stream: uint64 (6,).
    """
    key0, key1 = stream[0], stream[1]
    c0, c1, c2, c3 = stream[2], stream[3], stream[4], stream[5]
    for _ in range(10):
        product0 = _MULTIPLIER_0 * c0
        product1 = _MULTIPLIER_1 * c2
        c0, c1, c2, c3 = (
            (product1 >> _SHIFT) ^ c1 ^ key0,
            product1 & _LOW,
            (product0 >> _SHIFT) ^ c3 ^ key1,
            product0 & _LOW,
        )
        key0 = (key0 + _WEYL_0) & _LOW
        key1 = (key1 + _WEYL_1) & _LOW
    return c0, c1, c2, c3


@compiled
def uniform(stream, low, high):  # type: ignore[no-untyped-def]
    """
    Return a number of U(low, high), float64 of 53 random bits, and advance the stream.

    :param stream: uint64 (6,), its last counter word is advanced.
    :param high: upper end, excluded.
    """
    word0, word1, _, _ = philox(stream)
    stream[5] = stream[5] + np.uint64(1)
    # 32 bits of one word before 21 of the next, as many as a float64 holds
    bits = (word0 << np.uint64(21)) | (word1 >> np.uint64(11))
    return low + (high - low) * (np.float64(bits) / 9007199254740992.0)
