"""Laws of discs that stand for surfaces."""

import numpy as np
import pytest

from socialnav_core.sensing import (
    beam_angles,
    cast_rays,
    grid_returns,
    pooled,
    Rays,
    SurfaceSettings,
    surrounding_discs,
)

ROBOT = np.array([1.0, 2.0])
NOBODY = np.zeros((0, 2)), np.zeros(0)


def discs(points, people=NOBODY, **settings):
    """Return the centres of the discs around ROBOT."""
    return surrounding_discs(
        np.array(points, float).reshape(-1, 2), ROBOT, *people, SurfaceSettings(**settings)
    )[0]


def test_the_rim_of_a_disc_touches_the_return_and_nothing_of_it_is_nearer():
    (centre,) = discs([[4.0, 6.0]])
    np.testing.assert_allclose(centre, ROBOT + np.array([0.6, 0.8]) * 5.3)


def seen(position, radius, bounds=np.inf):
    """Return the points that a scan from ROBOT hits."""
    angles = beam_angles(720)
    ranges, _ = cast_rays(ROBOT, angles, np.array(position), np.array(radius), bounds)
    rays = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    hit = np.isfinite(ranges)
    return ROBOT + ranges[hit, None] * rays[hit]


@pytest.mark.parametrize('largest', [0.0, 2.0])
def test_the_clearance_of_the_discs_is_that_of_the_surface(largest):
    points = seen([[3.0, 1.0]], [0.7])
    settings = SurfaceSettings(disc_radius=0.2, largest_circle=largest)
    centres, radii = surrounding_discs(points, ROBOT, *NOBODY, settings)
    clearance = (np.linalg.norm(centres - ROBOT, axis=1) - radii).min()
    assert clearance == pytest.approx(np.sqrt(5.0) - 0.7, abs=1e-3)


def test_round_things_become_one_disc_each_of_their_place_and_size():
    position, radius = np.array([[3.0, 1.0], [-1.0, 4.0]]), np.array([0.7, 1.2])
    points = seen(position, radius)
    noise = np.random.default_rng(0).normal(scale=0.02, size=points.shape)
    centres, radii = surrounding_discs(points + noise, ROBOT, *NOBODY, SurfaceSettings())
    order = np.argsort(radii)
    np.testing.assert_allclose(centres[order], position, atol=0.1)
    np.testing.assert_allclose(radii[order], radius, atol=0.1)


@pytest.mark.parametrize('sectors', [12, 36])
def test_straight_walls_become_one_small_disc_in_each_sector(sectors):
    points = seen(np.zeros((0, 2)), [], bounds=4.0)
    settings = SurfaceSettings(sectors=sectors, max_range=20.0)
    _, radii = surrounding_discs(points, ROBOT, *NOBODY, settings)
    assert len(radii) == sectors and (radii == settings.disc_radius).all()


def test_the_nearest_return_of_a_sector_counts():
    (centre,) = discs(ROBOT + [[3.0, 0.1], [2.0, 0.1], [4.0, 0.1]])
    assert np.linalg.norm(centre - ROBOT) == pytest.approx(np.hypot(2.0, 0.1) + 0.3)


def test_returns_beyond_the_range_are_dropped():
    assert len(discs([[8.0, 2.0]], max_range=6.0)) == 0
    assert len(discs([[8.0, 2.0]], max_range=7.5)) == 1


def test_points_outside_of_the_bounds_are_dropped():
    assert len(discs([[4.0, 2.0]], bounds=4.1)) == 1
    assert len(discs([[4.0, 2.0]], bounds=3.9)) == 0


def test_returns_of_known_people_are_masked_out_and_others_are_not():
    people = np.array([[3.0, 2.0]]), np.array([0.3])
    assert len(discs([[2.6, 2.0]], people, people_margin=0.2)) == 0
    assert len(discs([[2.6, 2.0]], people, people_margin=0.05)) == 1


def test_a_masked_return_does_not_hide_what_is_behind_it():
    people = np.array([[3.0, 2.0]]), np.array([0.3])
    (centre,) = discs([[2.7, 2.05], [5.0, 2.05]], people)
    assert centre[0] > 5.0


def test_only_occupied_cells_of_a_grid_return():
    levels = np.array([[0, 100, -1], [64, 65, 0]])
    np.testing.assert_allclose(grid_returns(levels, 0.5, 65), [[0.75, 0.25], [0.75, 0.75]])


def test_a_square_of_cells_is_as_occupied_as_its_most_occupied_cell():
    levels = np.array([[0, 0, 7], [100, -1, -1], [-1, -1, 65]], dtype=np.int8)
    np.testing.assert_array_equal(pooled(levels, 2), [[100, 7], [-1, 65]])
    assert pooled(levels, 1) is levels


def test_returns_within_the_footprint_are_the_robot_itself():
    assert len(discs(ROBOT + [[0.2, 0.1]])) == 1
    assert len(discs(ROBOT + [[0.2, 0.1]], footprint=0.25)) == 0


def arc(centre, radius, begin, end, count=60):
    """Return points on a part of a circle."""
    angles = np.linspace(begin, end, count)
    return centre + radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


@pytest.mark.parametrize(
    ('place', 'begin', 'end'),
    [((0.0, 0.0), -np.pi, np.pi), ((0.5, 0.3), -np.pi, np.pi), ((1.2, 0.0), -1.5, 1.5)],
    ids=['lobby', 'lobby off its centre', 'niche'],
)
def test_a_surface_around_the_robot_does_not_become_a_disc_over_it(place, begin, end):
    points = arc(ROBOT + place, 1.5, begin, end)
    centres, radii = surrounding_discs(points, ROBOT, *NOBODY, SurfaceSettings())
    gap = np.linalg.norm(centres - ROBOT, axis=1) - radii
    true = np.linalg.norm(points - ROBOT, axis=1).min()
    assert gap.min() == pytest.approx(true, abs=1e-9)


def test_a_circle_that_a_ray_crosses_is_no_disc():
    surface = arc(ROBOT + [3.0, 0.0], 1.0, 2.4, 3.0)  # beside the middle of a niche's mirror image
    through = Rays(ROBOT, np.concatenate([surface, [ROBOT + [6.0, 0.4]]]))
    beside = Rays(ROBOT, np.concatenate([surface, [ROBOT + [6.0, 3.0]]]))
    for rays, largest in ((through, 0.3), (beside, 1.0)):
        _, radii = surrounding_discs(surface, ROBOT, *NOBODY, SurfaceSettings(), rays=rays)
        assert radii.max() == pytest.approx(largest, abs=1e-6)


def test_no_points_give_no_discs():
    assert discs([]).shape == (0, 2)
