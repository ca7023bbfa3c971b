"""Laws of the benchmark of robots that measure."""

from types import SimpleNamespace

import numpy as np

from benchmarks.core.sensors import changed, Perception, row, run, Settings
from socialnav_core.simulation import make_scenario, Outcome, Simulator

CASES = SimpleNamespace(model='orca', scenario='simple', episodes=2, seed=3, split='validation')
EXACT = {'scanner.noise': 0.0, 'detector.noise': 0.0, 'detector.missed': 0.0}


def test_a_case_ends_alike_however_many_are_run_beside_it():
    outcome, duration = run(CASES, Settings())
    fewer = SimpleNamespace(**{**vars(CASES), 'episodes': 1})
    again = run(fewer, Settings())
    np.testing.assert_array_equal(outcome[:1], again[0])
    np.testing.assert_array_equal(duration[:1], again[1])
    assert (outcome != Outcome.NONE).all()


def test_settings_are_changed_where_their_names_say():
    settings = changed(Settings(), {'tracker.gate': 5.0, 'max_agents': 7})
    assert (settings.tracker.gate, settings.max_agents) == (5, 7)
    assert settings.surfaces == Settings().surfaces


def test_a_robot_with_exact_sensors_knows_everybody_whom_it_can_see():
    simulator = Simulator(make_scenario('simple'))
    state = simulator.reset(seed=3, cases=[0])
    perception = Perception(changed(Settings(), EXACT | {'surfaces.max_range': 20.0}), 0, 0)
    for _ in range(10):
        perception.detect(state)
        state = simulator.advance(np.zeros((1, 2)), 0.05)[0]
    perception.detect(state)
    position, velocity, _, static = perception.agents(state)
    walking = ~state.agents.static[0]
    order = np.argsort(position[~static, 0])
    true = np.argsort(state.agents.position[0, walking, 0])
    np.testing.assert_allclose(
        position[~static][order], state.agents.position[0, walking][true], atol=0.05
    )
    np.testing.assert_allclose(
        velocity[~static][order], state.agents.velocity[0, walking][true], atol=0.3
    )
    gap = np.linalg.norm(position[static][:, None] - state.agents.position[0, ~walking], axis=-1)
    assert (gap.min(axis=1) < 0.35).all() and static.any()


def test_a_row_counts_every_outcome():
    outcome = np.array([Outcome.GOAL, Outcome.GOAL, Outcome.TIMEOUT, Outcome.COLLISION_OBSTACLE])
    name, success, *others = row('name', outcome, np.array([10.0, 12.0, 25.0, 1.0]))
    assert name == 'name' and success.startswith('0.500 [')
    assert others == ['0', '1', '0', '1', '11.00 s']
