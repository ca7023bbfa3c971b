"""Laws of the random streams."""

import itertools

import torch

from socialnav_core.config import PolicyConfig
from socialnav_core.training.randomness import generator, initial_network, Purpose


def test_streams_of_different_seeds_purposes_and_iterations_differ():
    keys = itertools.product((0, 1), Purpose, (0, 1))
    draws = [tuple(generator(*key).integers(2**62, size=4)) for key in keys]
    assert len(set(draws)) == len(draws)


def test_the_same_key_gives_the_same_numbers():
    first, second = (generator(5, Purpose.REPLAY, 7).random(8) for _ in range(2))
    assert (first == second).all()


def test_initial_weights_follow_from_the_seed_alone():
    torch.manual_seed(1)
    first = initial_network(PolicyConfig(), seed=3)
    torch.manual_seed(2)
    second, other = initial_network(PolicyConfig(), seed=3), initial_network(PolicyConfig(), 4)
    weights = [
        torch.cat([p.flatten() for p in net.parameters()]) for net in (first, second, other)
    ]
    assert weights[0].equal(weights[1]) and not weights[0].equal(weights[2])


def test_initial_weights_leave_the_generator_of_torch_alone():
    torch.manual_seed(1)
    expected = torch.rand(3)
    torch.manual_seed(1)
    initial_network(PolicyConfig(), seed=3)
    assert torch.rand(3).equal(expected)
