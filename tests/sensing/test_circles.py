"""Laws of circles through points."""

import numpy as np
import pytest

from socialnav_core.sensing.circles import circles_of, fitted_circle, groups_of


def arc(x, y, radius, begin=0.0, end=1.5, count=20):
    """Return points on a circle."""
    angles = np.linspace(begin, end, count)
    return np.array([x, y]) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


@pytest.mark.parametrize('end', [0.5, 3.0, 6.0])
def test_points_of_an_arc_have_the_circle_of_the_arc(end):
    found = fitted_circle(arc(3.0, -40.0, 0.8, end=end))
    assert found == pytest.approx((3.0, -40.0, 0.8, 0.0), abs=1e-6)


def test_points_of_a_corner_are_far_from_their_circle():
    side = np.linspace(0.0, 1.0, 20)[:, None]
    corner = np.concatenate([side * [1.0, 0.0], side * [0.0, 1.0]])
    assert fitted_circle(corner)[3] > 0.05


def test_points_are_cut_where_neighbours_are_far_apart_and_nowhere_else():
    behind = arc(-3.0, 0.0, 0.5, begin=-1.0, end=1.0)  # across the direction of pi
    groups = groups_of(np.concatenate([arc(3.0, 0.0, 0.5), behind]))
    assert sorted(map(len, groups)) == [20, 20]
    assert {tuple(np.sign(group[:, 0])) for group in groups} == {(1.0,) * 20, (-1.0,) * 20}


def test_only_circles_of_the_wanted_sizes_are_found():
    points = np.concatenate([arc(3.0, 0.0, 0.5, 2.0, 4.0), arc(0.0, 6.0, 1.5, 4.0, 5.5, 40)])
    centres, radii = circles_of(points, 1.0, 2.0, 0.04)
    np.testing.assert_allclose(centres, [[0.0, 6.0]], atol=1e-6)
    assert radii == pytest.approx([1.5])


def test_few_points_are_no_circle_and_none_are_none():
    for points in (arc(3.0, 0.0, 0.5, count=4), np.zeros((0, 2))):
        centres, radii = circles_of(points, 0.0, 10.0, 0.04)
        assert (centres.shape, radii.shape) == ((0, 2), (0,))
