"""Laws of what the beams of a scan say."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.sensing import Geometry, Readings, scan_beams

QUARTER = Geometry(0.0, np.pi / 2, np.pi / 2, 0.1, 5.0)
"""Of a scan of two beams."""


def beams(ranges, **readings):
    """Return returns and ends of beams by a quarter of a turn."""
    last = np.pi / 2 * (len(ranges) - 1)
    geometry = dataclasses.replace(QUARTER, angle_max=last)
    return scan_beams(np.array(ranges), geometry, Readings(**readings))


def test_a_scan_is_read_from_its_first_beam_on_in_either_direction():
    np.testing.assert_allclose(beams([1.0, 2.0])[0], [[1.0, 0.0], [0.0, 2.0]], atol=1e-12)
    back = dataclasses.replace(QUARTER, angle_max=-np.pi / 2, angle_increment=-np.pi / 2)
    hit, _ = scan_beams(np.array([1.0, 2.0]), back)
    np.testing.assert_allclose(hit, [[1.0, 0.0], [0.0, -2.0]], atol=1e-12)


@pytest.mark.parametrize('free', [np.inf, np.nan, 0.0, 0.05, 5.1, -1.0])
def test_a_beam_without_a_valid_range_hits_nothing(free):
    np.testing.assert_allclose(beams([1.0, free])[0], [[1.0, 0.0]])


def test_what_is_too_near_to_be_measured_stands_at_the_shortest_range():
    np.testing.assert_allclose(beams([-np.inf])[0], [[0.1, 0.0]])


def test_a_scan_of_free_beams_hits_nothing_and_all_of_them_are_free_for_their_whole_length():
    hit, ends = beams([np.inf, np.inf])
    assert len(hit) == 0
    np.testing.assert_allclose(ends, [[5.0, 0.0], [0.0, 5.0]], atol=1e-12)


SPECIAL = [('inf', np.inf), ('nan', np.nan), ('zero', 0.0), ('beyond', 5.0), ('beyond', 65.5)]


@pytest.mark.parametrize(('name', 'value'), SPECIAL)
def test_what_a_value_means_is_what_the_driver_means(name, value):
    assert [len(part) for part in beams([1.0, value], **{name: 'failed'})] == [1, 1]
    assert [len(part) for part in beams([1.0, value], **{name: 'free'})] == [1, 2]
    hit, _ = beams([1.0, value], **{name: 'near'})
    np.testing.assert_allclose(hit, [[1.0, 0.0], [0.0, 0.1]], atol=1e-12)


@pytest.mark.parametrize(('name', 'value'), SPECIAL)
def test_a_hall_without_returns_is_free_where_its_value_means_so(name, value):
    assert len(beams([value] * 3, **{name: 'free'})[1]) == 3


@pytest.mark.parametrize('ranges', [[], [np.nan, np.nan], [0.0, 0.0], [65.5, np.nan]])
def test_a_scan_that_measured_nothing_is_refused(ranges):
    with pytest.raises(ValueError, match=f'0 of {len(ranges)} beams measured'):
        beams(ranges)


def test_a_scan_of_which_hardly_any_beam_measured_anything_is_refused():
    ranges = np.full(100, np.nan)
    ranges[:9] = np.inf
    step = 2 * np.pi / 100
    with pytest.raises(ValueError, match='9 of 100 beams measured'):
        scan_beams(ranges, Geometry(0.0, 99 * step, step, 0.1, 5.0))
    ranges[9] = 1.0
    assert len(scan_beams(ranges, Geometry(0.0, 99 * step, step, 0.1, 5.0))[0]) == 1


@pytest.mark.parametrize('field', range(5))
def test_a_scan_with_a_number_that_cannot_be_is_refused(field):
    numbers = list(dataclasses.astuple(QUARTER))
    numbers[field] = np.nan
    with pytest.raises(ValueError, match='NaN'):
        scan_beams(np.ones(2), Geometry(*numbers))


@pytest.mark.parametrize(
    ('changes', 'reason'),
    [
        ({'range_max': 0.0}, 'ranges from 0.1 to 0 m'),
        ({'range_max': 0.1}, 'ranges from 0.1 to 0.1 m'),
        ({'range_min': -1.0}, 'ranges from -1 to 5 m'),
        ({'angle_increment': 0.0, 'angle_max': 0.0}, 'an angle of 0'),
        ({'angle_increment': 4.0, 'angle_max': 4.0 * 3}, 'more than a turn'),
        ({'angle_increment': 0.01}, 'do not lead from 0 to 1.5708 rad'),
        ({'angle_increment': -np.pi / 6}, 'do not lead from'),
        ({'angle_max': 3 * np.pi / 2}, 'do not lead from'),
        ({'angle_min': 1e9, 'angle_max': 1e9}, 'more than a turn'),
    ],
)
def test_a_scan_that_cannot_be_is_refused_with_the_reason(changes, reason):
    geometry = dataclasses.replace(Geometry(0.0, np.pi / 2, np.pi / 6, 0.1, 5.0), **changes)
    with pytest.raises(ValueError, match=reason):
        scan_beams(np.ones(4), geometry)


@pytest.mark.parametrize('surplus', [-1, 0, 1])
def test_whether_the_last_beam_is_counted_makes_no_difference(surplus):
    step = np.pi / 100
    geometry = Geometry(0.0, (99 + surplus) * step, step, 0.1, 5.0)
    assert len(scan_beams(np.ones(100), geometry)[0]) == 100


def test_a_scan_of_more_beams_than_any_scanner_has_is_refused():
    with pytest.raises(ValueError, match='30000 beams, more than 20000'):
        scan_beams(np.ones(30000), Geometry(0.0, 3.0, 1e-4, 0.1, 5.0))
