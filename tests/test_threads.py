"""Laws of processor threads: few for our networks, and the caller's setting stays."""

import numpy as np
import pytest
import torch

from socialnav_core import threads
from socialnav_core.config import PolicyConfig
from socialnav_core.policies import build_network
from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.training import train


@pytest.fixture(autouse=True)
def two_threads():
    """Let the caller compute with two threads."""
    before = torch.get_num_threads()
    torch.set_num_threads(2)
    yield
    threads.set_threads(1)
    torch.set_num_threads(before)


@pytest.fixture
def inference(monkeypatch):
    """Return inference that notes how many threads its network is computed with."""
    result = ValueInference(build_network(PolicyConfig()))
    result.used = []
    forward = result.network.forward

    def noted(*arrays):
        result.used.append(torch.get_num_threads())
        return forward(*arrays)

    monkeypatch.setattr(result.network, 'forward', noted)
    return result


def decide(inference):
    inference.values(
        np.zeros((2, 6), np.float32), np.zeros((2, 3, 7), np.float32), np.ones((2, 3), bool)
    )


def test_networks_compute_with_one_thread_and_the_caller_keeps_its_own(inference):
    decide(inference)
    assert inference.used == [1]
    assert torch.get_num_threads() == 2


def test_another_number_can_be_chosen(inference):
    threads.set_threads(2)
    decide(inference)
    threads.set_threads(3)
    decide(inference)
    assert inference.used == [2, 3]
    with pytest.raises(ValueError, match='at least 1'):
        threads.set_threads(0)


def test_an_error_leaves_the_number_of_the_caller():
    with pytest.raises(KeyError), threads.chosen_threads():
        raise KeyError
    assert torch.get_num_threads() == 2


def test_training_computes_with_one_thread(tmp_path, monkeypatch):
    used = []

    class Stop(Exception):
        pass

    def stop(*_):
        used.append(torch.get_num_threads())
        raise Stop

    monkeypatch.setattr('socialnav_core.training.value_learning.with_available_precision', stop)
    with pytest.raises(Stop):
        train(None, tmp_path)
    assert used == [1]
