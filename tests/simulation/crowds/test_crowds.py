"""Laws of whoever moves the people."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError, CROWDS
from socialnav_core.config.scenario import RECORDED
from socialnav_core.simulation import crowds, make_scenario, Simulator

WORLDS, STEPS = 8, 12

REMEMBERING = '''
import numpy as np


class Dancers:
    """Walk in a circle of which everybody remembers where on it they are."""

    def __init__(self, scenario, batch_size):
        self.beat = np.zeros(batch_size)
        self.renewals = 0

    def reset(self, episodes, worlds):
        self.beat[worlds] = episodes.case_index[worlds]

    def decide(self, episodes, due, velocities):
        movers = episodes.scenario.pedestrians
        way = np.stack([np.cos(self.beat), np.sin(self.beat)], axis=-1)
        velocities[due, :movers] = way[due, None]
        self.beat[due] += 0.5

    def renew_goals(self, episodes):
        self.renewals += 1

    def get_state(self):
        return {'beat': self.beat.copy()}

    def set_state(self, arrays):
        self.beat = arrays['beat'].copy()


make_crowd = Dancers
'''


def world_of(crowd, name='hard', **settings):
    return dataclasses.replace(make_scenario(name), crowd=crowd, **settings)


def still(simulator, steps=STEPS):
    """Return the states in which the robot stands, the first included."""
    states = [simulator.reset(seed=3)]
    for _ in range(steps):
        states.append(simulator.step(np.zeros((simulator.batch_size, 2)))[4]['final_state'])
    return states


@pytest.fixture
def dancers(tmp_path, monkeypatch):
    """Add a crowd: a file, and its line in the table."""
    (tmp_path / 'dancers.py').write_text(REMEMBERING)
    monkeypatch.setattr(crowds, '__path__', [*crowds.__path__, str(tmp_path)])
    monkeypatch.setitem(CROWDS, 'dancers', 'people dance')
    return world_of('dancers')


def test_a_file_and_a_line_in_the_table_add_a_crowd(dancers):
    before, after = still(Simulator(dancers, WORLDS), steps=1)
    moved = after.agents.position - before.agents.position
    cases = np.arange(WORLDS)
    way = 0.25 * np.stack([np.cos(cases), np.sin(cases)], axis=-1)
    assert np.allclose(moved[:, :5], way[:, None]) and not moved[:, 5:].any()


def test_a_crowd_that_remembers_goes_on_where_it_was(dancers):
    one, other = Simulator(dancers, WORLDS), Simulator(dancers, WORLDS)
    still(one)
    other.reset(seed=1)
    other.set_state(one.get_state())
    for _ in range(3 * STEPS):
        state, copy = (each.step(np.zeros((WORLDS, 2)))[0] for each in (one, other))
        assert np.array_equal(state.agents.position, copy.agents.position)


def test_the_crowd_is_asked_for_goals_only_where_the_scenario_renews_them(dancers):
    for renew in (True, False):
        simulator = Simulator(dataclasses.replace(dancers, renew_goals=renew), WORLDS)
        still(simulator)
        assert simulator._crowd.renewals == STEPS * renew


def test_a_crowd_that_there_is_not_is_refused_by_name():
    with pytest.raises(ConfigError, match='crowd must be one of orca, non_reactive'):
        world_of('zombies')


def test_every_crowd_of_the_table_moves_people_and_no_obstacle():
    for crowd in CROWDS.keys() - RECORDED:
        first, *_, last = still(Simulator(world_of(crowd), WORLDS))
        moved = np.linalg.norm(last.agents.position - first.agents.position, axis=-1)
        assert moved[:, :5].mean() > 0.5 and not moved[:, 5:].any()


def test_who_does_not_react_walks_straight_at_the_goal_at_full_speed():
    scenario = world_of('non_reactive', 'crowd20', renew_goals=False)
    simulator = Simulator(scenario, WORLDS, 'disabled')
    states, goals = still(simulator), simulator.get_state()['goal'][simulator.active]
    assert len(goals) > 1
    paths = [state.agents.position[simulator.active] for state in states]
    for before, after in zip(paths[:-1], paths[1:], strict=True):
        ahead = goals - before
        distance = np.linalg.norm(ahead, axis=-1, keepdims=True)
        assert np.allclose(after - before, 0.25 * ahead / np.maximum(distance, 1.0))


def test_who_does_not_react_walks_alike_whoever_else_is_there():
    paths = []
    for visible in (False, True):
        simulator = Simulator(world_of('non_reactive', robot_visible=visible), WORLDS)
        paths.append([state.agents.position for state in still(simulator)])
    assert np.array_equal(*paths)
    reacting = [state.agents.position for state in still(Simulator(world_of('orca'), WORLDS))]
    assert np.array_equal(paths[0][0], reacting[0]) and not np.allclose(paths[0][-1], reacting[-1])


def test_who_does_not_react_gets_another_goal_on_arrival():
    world = world_of('non_reactive', 'simple', time_limit=3600.0, robot_radius=0.01)
    simulator = Simulator(world, 4)
    simulator.reset(seed=2)
    before = simulator.get_state()['goal'][:, :5]
    for _ in range(80):
        simulator.step(np.zeros((4, 2)))
    assert (simulator.get_state()['goal'][:, :5] != before).any(axis=-1).mean() > 0.5


def test_small_steps_lead_who_does_not_react_where_a_whole_step_does():
    whole, parts = (Simulator(world_of('non_reactive'), 4, 'disabled') for _ in range(2))
    whole.reset(seed=4)
    parts.reset(seed=4)
    for _ in range(6):
        one = whole.step(np.zeros((4, 2)))[0]
        for _ in range(5):
            other = parts.advance(np.zeros((4, 2)), 0.05)[0]
    assert np.allclose(one.agents.position, other.agents.position, atol=1e-9)
