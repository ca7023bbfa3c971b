"""Laws of what messages hold."""

import subprocess
import sys

import numpy as np
import pytest

from socialnav_core.messages import (
    agent_states,
    attention_markers,
    planned_path,
    predicted_path,
    twist,
)
from socialnav_core.messages.markers import COLORS, DELETE_ALL
from socialnav_core.simulation import make_scenario, Simulator


@pytest.fixture
def state():
    return Simulator(make_scenario('hard'), batch_size=1).reset(seed=0, cases=[0])


def places(path):
    """Return the positions of a path, (poses, 2)."""
    return np.array([[one['pose']['position'][axis] for axis in 'xy'] for one in path['poses']])


def test_every_agent_is_told_once_as_what_it_is_by_its_place_in_the_state(state):
    agents = state.agents
    for static in (False, True):
        told = agent_states(state, static, 7, 'odom')['agents']
        ids = [one['id'] for one in told]
        assert ids == np.flatnonzero(agents.valid[0] & (agents.static[0] == static)).tolist()
        assert [one['position']['x'] for one in told] == agents.position[0, ids, 0].tolist()


def test_a_path_begins_at_the_robot_and_is_as_long_as_the_way_of_a_second(state):
    found = places(predicted_path(state, np.array([0.3, -0.4]), 'holonomic', 7, 'odom'))
    np.testing.assert_allclose(found[0], state.robot.position[0])
    np.testing.assert_allclose(found[-1] - found[0], [0.3, -0.4])


def test_the_path_of_a_differential_drive_is_an_arc(state):
    state.robot.heading[:] = 0.0
    found = places(predicted_path(state, np.array([0.5, np.pi]), 'differential', 7, 'odom'))
    np.testing.assert_allclose(found[-1] - found[0], [0.0, 1.0 / np.pi], atol=1e-9)


def test_the_path_of_a_plan_leads_from_the_robot_through_all_of_it(state):
    plan = state.robot.position[0] + np.array([[0.0, 1.0], [-1.0, 1.0]])
    path = planned_path(state, plan, 7, 'odom')
    np.testing.assert_allclose(places(path), [state.robot.position[0], *plan])
    turned = [one['pose']['orientation'] for one in path['poses'][1:]]
    headings = [2 * np.arctan2(one['z'], one['w']) for one in turned]
    np.testing.assert_allclose(headings, [np.pi / 2, np.pi], atol=1e-9)


def test_an_agent_is_the_denser_the_more_it_is_looked_at(state):
    weights = np.arange(state.agents.count) / 10
    first, *markers = attention_markers(state, weights, 7, 'odom')['markers']
    assert first['action'] == DELETE_ALL
    assert [one['color']['a'] for one in markers] == weights.tolist()
    assert COLORS['attention']['a'] == 1.0, 'the colour of all such markers has been changed'


def test_a_robot_that_cannot_move_sideways_is_told_to_turn():
    command = np.array([0.5, 0.2])
    told = {name: twist(command, name) for name in ('differential', 'holonomic')}
    assert told['differential'] == {'linear': {'x': 0.5, 'y': 0.0}, 'angular': {'z': 0.2}}
    assert told['holonomic'] == {'linear': {'x': 0.5, 'y': 0.2}, 'angular': {'z': 0.0}}


def test_messages_load_without_networks_and_pictures():
    code = (
        'import sys, socialnav_core.messages; '
        "heavy = {'torch', 'matplotlib', 'socialnav_core.policies'} & set(sys.modules); "
        'sys.exit(str(heavy) if heavy else 0)'
    )
    run = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
