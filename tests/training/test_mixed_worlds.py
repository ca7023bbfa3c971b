"""Laws of worlds of many kinds that are stepped as one batch."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.simulation import make_scenario, PackingError, Simulator
from socialnav_core.training import mixed_worlds, train
from socialnav_core.training.mixed_worlds import draw_kind, MixedWorlds
from socialnav_core.training.randomness import generator, Purpose

KINDS = 8
LARGEST = dataclasses.replace(make_scenario('plaza'), pedestrians=6, obstacles=3)


@pytest.fixture
def worlds():
    """Return worlds of eight kinds, two each, laid out."""
    mixed = MixedWorlds(LARGEST, KINDS, 2 * KINDS, seed=3)
    mixed.reset(seed=3, split='train')
    return mixed


def stand(state):
    """Return commands to stand."""
    return np.zeros((state.batch_size, 2))


def test_there_are_worlds_without_anybody_and_worlds_with_nearly_all(worlds):
    people = (worlds.state.agents.valid & ~worlds.state.agents.static).sum(axis=1)
    assert people.min() == 0 and people.max() >= 5 and len(set(people.tolist())) >= 4


def test_agents_that_a_kind_lacks_are_not_valid_and_do_not_move(worlds):
    before = worlds.state
    after = worlds.step(stand(before))[0]
    missing = ~before.agents.valid
    assert missing.any() and np.array_equal(after.agents.valid, before.agents.valid)
    assert not after.agents.velocity[missing].any()


def test_a_world_of_the_mixture_goes_as_it_would_alone(worlds):
    kind = 5
    alone = Simulator(worlds._simulators[kind].scenario, 2)
    alone.change_scenario(alone.scenario, worlds._simulators[kind]._scenario_of)
    expected, state = alone.reset(seed=3, split='train'), worlds.state
    for _ in range(12):
        mine = state.select(np.arange(2 * kind, 2 * kind + 2))
        count = expected.agents.count
        assert np.array_equal(mine.agents.position[:, :count], expected.agents.position)
        state = worlds.step(stand(state))[0]
        expected = alone.step(stand(expected))[0]


def test_every_case_has_a_number_of_its_own(worlds):
    state, seen = worlds.state, []
    for _ in range(400):
        state, _, terminated, truncated, info = worlds.step(stand(state))
        ended = terminated | truncated
        seen.extend(info['case_index'][ended].tolist())
    assert len(seen) > KINDS and len(seen) == len(set(seen))


def test_given_cases_are_run_once_each(worlds):
    state, seen = worlds.reset(seed=3, split='train', cases=range(21)), []
    while worlds.active.any():
        state, _, terminated, truncated, info = worlds.step(stand(state))
        ended = info['active'] & (terminated | truncated)
        seen.extend(info['case_index'][ended].tolist())
    assert sorted(seen) == list(range(21))


def test_worlds_go_on_from_a_stored_state(worlds):
    state = worlds.state
    for _ in range(5):
        state = worlds.step(stand(state))[0]
    other = MixedWorlds(LARGEST, KINDS, 2 * KINDS, seed=3)
    other.set_state(worlds.get_state())
    for _ in range(60):
        one, same = worlds.step(stand(state))[0], other.step(stand(state))[0]
        assert np.array_equal(one.agents.position, same.agents.position)


def test_the_oracle_knows_where_everybody_goes(worlds):
    before, velocities = worlds.state, worlds.next_agent_velocities()
    worlds.step(stand(before))
    moved = worlds.state.agents.position - before.agents.position
    same = worlds.state.time > 0.0  # others are in their next case
    assert np.allclose(moved[same], velocities[same] * LARGEST.time_step)


def test_numbers_are_drawn_up_to_those_of_the_scenario():
    draws = generator(0, Purpose.MIXED_WORLDS)
    kinds = [draw_kind(LARGEST, k / 200, draws) for k in range(200)]
    assert {kind.pedestrians for kind in kinds} == set(range(LARGEST.pedestrians + 1))
    assert {kind.obstacles for kind in kinds} == set(range(LARGEST.obstacles + 1))


def test_kinds_that_never_find_room_are_refused(monkeypatch):
    full = dataclasses.replace(LARGEST, pedestrians=0, obstacle_radius_max=9.0)
    full = dataclasses.replace(full, obstacle_radius_min=9.0)
    monkeypatch.setattr(mixed_worlds, 'draw_kind', lambda *_: full)
    with pytest.raises(PackingError, match='scenario.obstacles'):
        MixedWorlds(full, 1, 1, seed=0)


def test_a_run_in_mixed_worlds_leaves_a_checkpoint_and_its_card(tiny_config, tmp_path):
    settings = dataclasses.replace(tiny_config.training, kinds=2)
    config = dataclasses.replace(tiny_config, training=settings)
    train(config, tmp_path / 'run', progress=False)
    card = (tmp_path / 'run' / 'README.md').read_text()
    assert '2 kinds of worlds' in card


@pytest.mark.parametrize('changes', [{'kinds': 3}, {'kinds': 8}])
def test_kinds_that_do_not_share_the_worlds_evenly_are_refused(tiny_config, changes):
    with pytest.raises(ConfigError, match='multiple of training.kinds'):
        dataclasses.replace(tiny_config.training, **changes)
