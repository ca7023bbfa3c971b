"""Laws of what a robot makes of any surroundings, against a march along every ray."""

import dataclasses

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np

from socialnav_core.sensing import (
    Geometry,
    Rays,
    Readings,
    scan_beams,
    SurfaceSettings,
    surrounding_discs,
)

BEAMS, STEP, REACH = 360, 0.02, 7.0
"""Number of beams, distance of the points on each and length of them, m."""
PASSED = 0.1
"""What the place of a circle may be wrong by, m."""
NOBODY = np.zeros((0, 2)), np.zeros(0)
ANGLES = np.linspace(-np.pi, np.pi, BEAMS, endpoint=False)
RAYS = np.stack([np.cos(ANGLES), np.sin(ANGLES)], axis=-1)
GEOMETRY = Geometry(ANGLES[0], ANGLES[-1], ANGLES[1] - ANGLES[0], 0.0, REACH)
number = st.floats(-6.0, 6.0)


@dataclasses.dataclass(frozen=True)
class World:
    """What is solid: discs, boxes, all outside of a round room, all outside of a square one."""

    discs: list[tuple[float, float, float]]
    """Centre and radius, m."""
    boxes: list[tuple[float, float, float, float]]
    """Centre and half sides, m."""
    lobby: tuple[float, float, float] | None
    """Centre and radius of a round room."""
    room: float | None
    """Half-width of a square one, m."""

    def solid(self, x, y):
        """Return where something is, bool, shaped like the coordinates, m."""
        result = np.zeros(np.shape(x), dtype=bool)
        for centre_x, centre_y, radius in self.discs:
            result |= (x - centre_x) ** 2 + (y - centre_y) ** 2 <= radius**2
        for centre_x, centre_y, width, height in self.boxes:
            result |= (np.abs(x - centre_x) <= width) & (np.abs(y - centre_y) <= height)
        if self.lobby is not None:
            centre_x, centre_y, radius = self.lobby
            result |= (x - centre_x) ** 2 + (y - centre_y) ** 2 >= radius**2
        if self.room is not None:
            result |= np.maximum(np.abs(x), np.abs(y)) >= self.room
        return result


worlds = st.builds(
    World,
    discs=st.lists(st.tuples(number, number, st.floats(0.05, 2.0)), max_size=5),
    boxes=st.lists(
        st.tuples(number, number, st.floats(0.05, 2.0), st.floats(0.05, 2.0)), max_size=3
    ),
    lobby=st.none() | st.tuples(st.floats(-0.7, 0.7), st.floats(-0.7, 0.7), st.floats(1.0, 5.0)),
    room=st.none() | st.floats(0.5, 7.0),
).filter(lambda world: not world.solid(*(0.2 * RAYS.T)).any() and not world.solid(0.0, 0.0))
"""Worlds in which a robot at the origin, not larger than 0.2 m, touches nothing."""


def march(world, origin):
    """Return how far each ray goes until something is there, m, inf where nothing is."""
    along = np.arange(0.0, REACH, STEP)
    points = origin + along[:, None, None] * RAYS  # (steps, beams, 2)
    solid = world.solid(points[..., 0], points[..., 1])
    return np.where(solid.any(axis=0), along[solid.argmax(axis=0)], np.inf)


def discs_of(world, origin, noise, seed, **changes):
    """Return discs of a scan from a place, and how far its rays went."""
    true = march(world, origin)
    generator = np.random.default_rng(seed)
    ranges = np.maximum(true + noise * generator.standard_normal(BEAMS), 0.0)
    hit, ends = scan_beams(ranges, GEOMETRY, Readings(zero='near'), REACH)
    rays = Rays(origin, origin + ends)
    options = SurfaceSettings(**changes)
    found = surrounding_discs(origin + hit, np.zeros(2), *NOBODY, options, rays=rays)
    return *found, true


lasers = st.tuples(st.floats(-0.15, 0.15), st.floats(-0.1, 0.1)).map(np.array)
examples = settings(max_examples=60, deadline=None, derandomize=True)
measured = given(
    world=worlds, laser=lasers, noise=st.sampled_from([0.0, 0.02]), seed=st.integers(0, 99)
)


@examples
@measured
def test_no_disc_contains_the_centre_of_the_robot(world, laser, noise, seed):
    centres, radii, _ = discs_of(world, laser, noise, seed)
    assert (np.hypot(*centres.T) > radii).all()


@examples
@measured
def test_no_round_thing_contains_a_point_that_a_ray_passed(world, laser, noise, seed):
    centres, radii, true = discs_of(world, laser, noise, seed, disc_radius=0.01)
    along = np.arange(0.0, REACH, STEP)[:, None]
    for ray, length in zip(RAYS, np.minimum(true, REACH), strict=True):
        passed = laser + along[along[:, 0] < length - PASSED] * ray
        depth = radii - np.hypot(*np.moveaxis(passed[:, None] - centres, -1, 0))
        assert (depth < np.minimum(PASSED, radii / 2 + 0.02)).all()


@examples
@measured
def test_the_nearest_clearance_is_the_true_one(world, laser, noise, seed):
    centres, radii, _ = discs_of(world, laser, noise, seed)
    nearest = march(world, np.zeros(2)).min()
    told = (np.hypot(*centres.T) - radii).min(initial=np.inf)
    if nearest < SurfaceSettings().max_range - PASSED:
        assert abs(told - nearest) < PASSED
    else:
        assert told >= nearest - PASSED


@examples
@measured
def test_a_disc_of_a_sector_covers_free_ground_only_beside_a_surface(world, laser, noise, seed):
    centres, radii, true = discs_of(world, laser, noise, seed, largest_circle=0.0)
    distance = np.hypot(*centres.T)
    touched = centres * ((distance - radii) / distance)[:, None]
    around = np.linspace(0.0, PASSED, 6)[:, None, None] * RAYS  # (rings, beams, 2)
    solid = world.solid(*np.moveaxis(touched[:, None, None] + around, -1, 0))
    assert solid.any(axis=(1, 2)).all()
    along = np.arange(0.0, REACH, STEP)[:, None]
    for ray, length in zip(RAYS, np.minimum(true, REACH), strict=True):
        passed = laser + along[along[:, 0] < length - PASSED] * ray
        covered = np.hypot(*np.moveaxis(passed[:, None] - centres, -1, 0)) < radii
        beside = np.hypot(*np.moveaxis(passed[:, None] - touched, -1, 0))
        assert (beside[covered] <= 2 * SurfaceSettings().disc_radius + 1e-9).all()


@examples
@measured
def test_discs_of_sectors_stand_alone_in_sectors_of_their_own(world, laser, noise, seed):
    centres, _, _ = discs_of(world, laser, noise, seed, largest_circle=0.0)
    count = SurfaceSettings().sectors
    turn = np.arctan2(centres[:, 1], centres[:, 0]) / (2 * np.pi) % 1.0
    sectors = (turn * count).astype(int) % count
    assert len(set(sectors.tolist())) == len(sectors)
