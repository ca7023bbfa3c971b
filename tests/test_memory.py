"""Laws of asking for memory before it is needed."""

import dataclasses

import pytest

from socialnav_core import memory
from socialnav_core.config import ConfigError, make_scenario, read_config
from socialnav_core.config.reading import read_prediction_config

GIB = 2**30


def test_what_is_free_is_enough_and_what_is_not_is_refused(monkeypatch):
    monkeypatch.setattr(memory, 'available_memory', lambda: 2.0 * GIB)
    memory.require_memory(1.9 * GIB, 'it')
    with pytest.raises(ConfigError, match=r'it would need about 37\.0 GiB.* 2\.0 GiB are free'):
        memory.require_memory(37.0 * GIB, 'it')


def test_where_nobody_knows_what_is_free_nothing_is_refused(monkeypatch):
    monkeypatch.setattr(memory, 'available_memory', lambda: None)
    memory.require_memory(1e30, 'it')


def test_the_limit_of_a_container_counts(monkeypatch):
    limits = {'/sys/fs/cgroup/memory.current': 3.0 * GIB, '/sys/fs/cgroup/memory.max': 3.5 * GIB}
    monkeypatch.setattr(memory, 'number_in', limits.get)
    assert memory.available_memory() <= 0.5 * GIB


def test_everything_that_comes_with_the_package_fits_into_two_gibibytes():
    for name in ('sarl', 'gat4sn', 'quick', 'report_sarl', 'sarl_curriculum'):
        assert memory.training_bytes(read_config(name)) < 2 * GIB, name
    assert memory.prediction_bytes(read_prediction_config('mixed')) < 2 * GIB
    assert memory.evaluation_bytes(5000, 128, make_scenario('crowd20'), 81) < GIB


def test_more_of_anything_needs_more():
    config = read_config('sarl')
    least = memory.training_bytes(config)
    larger = {
        'worlds': 60_000, 'replay_capacity': 10**6, 'steps_per_iteration': 9000,
        'batch_size': 60_000,
    }  # fmt: skip
    for name, value in larger.items():
        more = dataclasses.replace(config.training, **{name: value})
        assert memory.training_bytes(dataclasses.replace(config, training=more)) > least, name
