"""Laws of ORCA; the reference is RVO2 itself, which computes in single precision."""

import numpy as np
import pyrvo
import pytest

from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step
from socialnav_core.simulation.crowds.orca_velocities import orca_velocities

REACH, NEIGHBORS, HORIZON, STEP = 10.0, 10, 5.0, 0.25


def random_scene(generator, pedestrians, obstacles, half_width=7.5):
    """Return position, velocity, preferred velocity, radius and top speed of discs apart."""
    agents = pedestrians + obstacles
    radius = generator.uniform(0.3, 0.5, agents)
    radius[pedestrians:] = generator.uniform(0.3, 2.5, obstacles)
    position = np.empty((agents, 2))
    largest_first = np.argsort(-radius)  # or the large ones find no room
    for rank, i in enumerate(largest_first):
        others = largest_first[:rank]
        while True:
            position[i] = generator.uniform(-half_width, half_width, 2)
            distances = np.linalg.norm(position[others] - position[i], axis=1)
            if np.all(distances > radius[others] + radius[i] + 0.01):
                break
    max_speed = generator.uniform(0.5, 1.5, agents)
    heading = generator.uniform(0.0, 2.0 * np.pi, (2, agents))
    headings = np.stack([np.cos(heading), np.sin(heading)], axis=2)
    velocity = headings[0] * (max_speed * generator.uniform(0.0, 1.0, agents))[:, None]
    preferred = headings[1] * max_speed[:, None]
    velocity[pedestrians:] = preferred[pedestrians:] = 0.0
    return position, velocity, preferred, radius, max_speed


def rvo2_velocities(position, velocity, preferred, radius, max_speed):
    """Return what RVO2 decides, (agents, 2)."""
    simulator = pyrvo.RVOSimulator(STEP, REACH, NEIGHBORS, HORIZON, HORIZON, 0.3, 1.0)
    for i in range(len(position)):
        simulator.add_agent(
            tuple(position[i]), REACH, NEIGHBORS, HORIZON, HORIZON, radius[i], max_speed[i],
            tuple(velocity[i]),
        )  # fmt: skip
        simulator.set_agent_pref_velocity(i, tuple(preferred[i]))
    simulator.do_step()
    return np.array([simulator.get_agent_velocity(i).to_tuple() for i in range(len(position))])


def differences(scenes):
    """Return how far each agent's velocity is from RVO2's, m/s, over all scenes."""
    return np.concatenate([
        np.abs(orca_velocities(*(array[None] for array in scene))[0] - rvo2_velocities(*scene))
        .max(axis=1)
        for scene in scenes
    ])  # fmt: skip


def batch_of_scenes(batch, pedestrians, obstacles, seed=0):
    """Return the arrays of random_scene with a leading batch axis."""
    generator = np.random.default_rng(seed)
    scenes = [random_scene(generator, pedestrians, obstacles) for _ in range(batch)]
    return [np.stack(arrays) for arrays in zip(*scenes, strict=True)]


def test_velocities_are_those_of_rvo2():
    generator = np.random.default_rng(1)
    sizes = zip(generator.integers(1, 21, 2000), generator.integers(0, 6, 2000), strict=True)
    errors = differences(random_scene(generator, *size) for size in sizes)
    # in single precision RVO2's fallback stops at a worse velocity once in some ten thousand
    assert np.mean(errors < 1e-4) >= 0.999


def test_a_dense_crowd_of_many_neighbours_decides_as_rvo2_does():
    generator = np.random.default_rng(2)
    errors = differences(random_scene(generator, 150, 0, half_width=10.0) for _ in range(5))
    assert np.mean(errors < 1e-4) >= 0.99


def test_overlapping_agents_part_as_in_rvo2():
    generator = np.random.default_rng(3)
    scenes = [random_scene(generator, 2, 0) for _ in range(200)]
    for position, _, _, radius, _ in scenes:
        position[1] = position[0] + generator.uniform(-0.5, 0.5, 2) * radius.sum()
    assert np.mean(differences(scenes) < 1e-4) >= 0.99


def test_invalid_agents_influence_nobody_and_get_zero():
    scene = batch_of_scenes(20, 6, 2)
    valid = np.ones((20, 8), bool)
    valid[:, [1, 4]] = False
    kept = [0, 2, 3, 5, 6, 7]
    alone = orca_velocities(*(array[:, kept] for array in scene))
    for array in scene:
        array[:, [1, 4]] = np.nan
    result = orca_velocities(*scene, valid=valid)
    np.testing.assert_array_equal(result[:, kept], alone)
    assert not result[:, [1, 4]].any()


def test_permuting_the_batch_permutes_the_result():
    scene = batch_of_scenes(20, 6, 2)
    order = np.random.default_rng(4).permutation(20)
    result = orca_velocities(*(array[order] for array in scene))
    np.testing.assert_array_equal(result, orca_velocities(*scene)[order])


def test_permuting_the_agents_permutes_the_result():
    scene = batch_of_scenes(20, 6, 2)
    order = np.random.default_rng(5).permutation(8)
    result = orca_velocities(*(array[:, order] for array in scene))
    np.testing.assert_allclose(result, orca_velocities(*scene)[:, order], atol=1e-9)


def head_on(responsibility):
    """Return the distance kept, m, by a disc that walks into another one at rest."""
    position = np.array([[[-4.0, 0.05], [0.0, 0.0]]])
    velocity, radius = np.zeros((1, 2, 2)), np.array([[0.3, 1.0]])
    closest = np.inf
    for _ in range(60):
        preferred = np.array([[[1.0, 0.0], [0.0, 0.0]]])
        decided = orca_velocities(
            position, velocity, preferred, radius, 1.0, responsibility=responsibility
        )
        velocity[:, 0] = decided[:, 0]
        position = position + STEP * velocity
        closest = min(closest, np.linalg.norm(position[0, 0] - position[0, 1]))
    assert position[0, 0, 0] > 1.3  # it went past
    return closest


def test_full_responsibility_lets_the_mover_alone_avoid_a_disc_at_rest():
    assert head_on(np.array([[0.5, 1.0]])) >= 1.3 - 1e-6


def test_full_responsibility_leaves_the_relative_velocity_outside_the_obstacle_at_once():
    # one step at full responsibility equals two agents' halves together
    position = np.array([[[-2.0, 0.1], [0.0, 0.0]]])
    velocity = np.array([[[1.0, 0.0], [0.0, 0.0]]])
    half = orca_velocities(position, velocity, velocity, 0.3, 10.0)
    whole = orca_velocities(
        position, velocity, velocity, 0.3, 10.0, responsibility=np.array([[0.5, 1.0]])
    )
    change, other_change = half[0, 0] - velocity[0, 0], half[0, 1] - velocity[0, 1]
    np.testing.assert_allclose(whole[0, 0] - velocity[0, 0], change - other_change, atol=1e-12)


def test_a_lone_agent_keeps_its_preferred_velocity():
    preferred = np.array([[[0.6, -0.3]]])
    result = orca_velocities(np.zeros((1, 1, 2)), np.zeros((1, 1, 2)), preferred, 0.3, 1.0)
    np.testing.assert_array_equal(result, preferred)


def test_agents_beyond_the_neighbor_distance_are_not_noticed():
    position = np.array([[[0.0, 0.0], [3.0, 0.0]]])
    velocity = np.array([[[1.0, 0.0], [-1.0, 0.0]]])
    reach = np.array([[2.9, 3.1]])
    result = orca_velocities(position, velocity, velocity, 0.3, 1.0, neighbor_distance=reach)
    np.testing.assert_array_equal(result[0, 0], velocity[0, 0])
    assert np.abs(result[0, 1] - velocity[0, 1]).max() > 0.01


def test_nobody_is_noticed_where_no_neighbours_are_allowed():
    scene = batch_of_scenes(3, 30, 0)
    np.testing.assert_allclose(orca_velocities(*scene, max_neighbors=0), scene[2], atol=1e-12)


@pytest.mark.parametrize('half_width', [1.5, 7.5])
def test_speed_never_exceeds_the_maximum(half_width):
    generator = np.random.default_rng(6)
    position = generator.uniform(-half_width, half_width, (200, 20, 2))  # overlaps as well
    velocity, preferred = generator.normal(0.0, 2.0, (2, 200, 20, 2))
    max_speed = generator.uniform(0.0, 1.5, (200, 20))
    result = orca_velocities(position, velocity, preferred, 0.3, max_speed)
    assert np.isfinite(result).all()
    assert (np.linalg.norm(result, axis=2) <= max_speed + 1e-9).all()


def test_coincident_agents_part_in_opposite_directions():
    result = orca_velocities(np.zeros((1, 2, 2)), np.zeros((1, 2, 2)), np.zeros((1, 2, 2)), 0.3, 1)
    assert result[0, 0, 0] * result[0, 1, 0] < 0.0


def test_only_movers_of_active_worlds_are_written():
    scene = batch_of_scenes(4, 5, 3)
    shape, active = (4, 8), np.array([True, False, True, False])
    out = np.full((4, 8, 2), 7.0)
    arguments = [np.ones(shape, bool), np.full(shape, 0.5), np.full(shape, REACH)]
    orca_step(Bodies(*scene, *arguments), Foresight(NEIGHBORS, HORIZON, STEP), active, 5, out)
    np.testing.assert_array_equal(out[active, :5], orca_velocities(*scene)[active, :5])
    assert (out[~active] == 7.0).all()
    assert (out[:, 5:] == 7.0).all()


@pytest.mark.parametrize('index', range(5))
def test_a_wrong_shape_is_an_error_that_names_the_argument(index):
    scene = batch_of_scenes(2, 3, 0)
    name = ['position', 'velocity', 'preferred_velocity', 'radius', 'max_speed'][index]
    scene[index] = scene[index][:, :2] if index else scene[index][0]
    with pytest.raises(ValueError, match=f'^{name} has shape'):
        orca_velocities(*scene)


@pytest.mark.parametrize('name', ['valid', 'responsibility', 'neighbor_distance'])
def test_a_wrong_shape_of_an_option_is_an_error(name):
    with pytest.raises(ValueError, match=f'^{name} has shape'):
        orca_velocities(*batch_of_scenes(2, 3, 0), **{name: np.ones((2, 4))})


def test_a_value_that_is_not_finite_is_an_error():
    scene = batch_of_scenes(2, 3, 0)
    scene[0][1, 2] = np.nan
    with pytest.raises(ValueError, match='position of a valid agent is not finite'):
        orca_velocities(*scene)


@pytest.mark.parametrize('name', ['time_horizon', 'time_step'])
def test_a_time_that_is_not_positive_is_an_error(name):
    with pytest.raises(ValueError, match='must be positive'):
        orca_velocities(*batch_of_scenes(2, 3, 0), **{name: 0.0})
