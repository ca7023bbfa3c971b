"""Laws of the random streams."""

import numpy as np

from socialnav_core.simulation.random_streams import GOALS, LAYOUT, philox, stream, uniform


def test_philox_gives_the_published_known_answers():
    # kat_vectors of the Random123 library, philox4x32-10
    zeros = np.zeros(6, np.uint64)
    ones = np.full(6, 0xFFFFFFFF, np.uint64)
    digits_of_pi = np.array(
        [0xA4093822, 0x299F31D0, 0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344], np.uint64
    )
    assert philox(zeros) == (0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8)
    assert philox(ones) == (0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD)
    assert philox(digits_of_pi) == (0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1)


def draws(*address, count=4):
    random = stream(*address)
    return [uniform(random, 0.0, 1.0) for _ in range(count)]


def test_streams_of_different_addresses_share_no_number():
    addresses = [
        ('test', 0, 0, LAYOUT),
        ('train', 0, 0, LAYOUT),
        ('test', 1, 0, LAYOUT),
        ('test', 2**32, 0, LAYOUT),
        ('test', 0, 1, LAYOUT),
        ('test', 0, 0, GOALS),
        ('test', 0, 0, GOALS, 1),
    ]
    numbers = [number for address in addresses for number in draws(*address)]
    assert len(set(numbers)) == len(numbers)


def test_the_same_address_gives_the_same_numbers():
    assert draws('test', 7, 3, GOALS, 2) == draws('test', 7, 3, GOALS, 2)


def test_draws_fill_their_range_evenly():
    numbers = 2.0 * np.array(draws('test', 0, 0, LAYOUT, count=20000))
    counts, _ = np.histogram(numbers, bins=20, range=(0.0, 2.0))
    assert counts.sum() == 20000
    assert np.abs(counts - 1000).max() < 150  # about five standard deviations
