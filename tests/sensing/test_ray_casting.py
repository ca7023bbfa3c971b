"""Laws of rays among discs and walls."""

import numpy as np
import pytest

from socialnav_core.sensing.ray_casting import beam_angles, cast_rays, NOTHING, WALL

ORIGIN = np.zeros(2)
NOBODY = np.zeros((0, 2)), np.zeros(0)


def discs(*triples):
    """Return centres and radii of discs (x, y, radius)."""
    array = np.array(triples, dtype=float)
    return array[:, :2], array[:, 2]


def test_a_ray_at_a_disc_ends_at_its_rim():
    length, hit = cast_rays(ORIGIN, np.array([0.0]), *discs((3.0, 0.0, 1.0)))
    assert length == pytest.approx([2.0]) and hit.tolist() == [0]


def test_a_ray_beside_the_centre_ends_where_the_circle_equation_says():
    length, _ = cast_rays(ORIGIN, np.array([0.0]), *discs((3.0, 0.6, 1.0)))
    assert length == pytest.approx([3.0 - 0.8])


@pytest.mark.parametrize('angle', [np.pi, np.pi / 2, 0.5])
def test_a_ray_that_points_elsewhere_hits_nothing(angle):
    length, hit = cast_rays(ORIGIN, np.array([angle]), *discs((3.0, 0.0, 1.0)))
    assert np.isinf(length).all() and hit.tolist() == [NOTHING]


def test_the_nearer_of_two_discs_hides_the_other():
    angles = np.array([0.0])
    _, hit = cast_rays(ORIGIN, angles, *discs((6.0, 0.0, 1.0), (3.0, 0.0, 0.5)))
    assert hit.tolist() == [1]


def test_a_ray_from_within_a_disc_has_length_zero():
    length, _ = cast_rays(ORIGIN, np.array([0.3, 2.0]), *discs((0.2, 0.0, 1.0)))
    assert length.tolist() == [0.0, 0.0]


def test_rays_end_at_the_walls_of_the_square():
    angles = np.array([0.0, np.pi / 4, np.pi / 2, -np.pi / 2])
    length, hit = cast_rays(np.array([1.0, 1.0]), angles, *NOBODY, bounds=4.0)
    assert length == pytest.approx([3.0, 3.0 * np.sqrt(2), 3.0, 5.0])
    assert (hit == WALL).all()


def test_without_walls_and_discs_every_ray_is_free():
    length, hit = cast_rays(ORIGIN, beam_angles(8), *NOBODY)
    assert np.isinf(length).all() and (hit == NOTHING).all()


def test_the_end_of_every_ray_lies_on_what_it_hit():
    generator = np.random.default_rng(0)
    position, radius = generator.uniform(-4, 4, (6, 2)), generator.uniform(0.1, 0.8, 6)
    origin = np.array([-0.3, 4.5])
    angles = beam_angles(360)
    length, hit = cast_rays(origin, angles, position, radius, bounds=5.0)
    ends = origin + length[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    of_disc = hit >= 0
    rims = np.linalg.norm(ends[of_disc] - position[hit[of_disc]], axis=1)
    np.testing.assert_allclose(rims, radius[hit[of_disc]], atol=1e-9)
    np.testing.assert_allclose(np.abs(ends[hit == WALL]).max(axis=1), 5.0, atol=1e-9)
    assert of_disc.any() and (hit == WALL).any()


def test_beams_go_around_once_from_straight_behind():
    angles = beam_angles(4)
    np.testing.assert_allclose(angles, [-np.pi, -np.pi / 2, 0.0, np.pi / 2])
