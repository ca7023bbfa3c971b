"""Laws of stepping a batch of worlds."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.simulation import make_scenario, Outcome, Simulator


def to_goal(state):
    ahead = state.robot.goal - state.robot.position
    return ahead / np.maximum(np.linalg.norm(ahead, axis=-1, keepdims=True), 1.0)


def equal(one, other):
    others = other.arrays()
    return all(np.array_equal(array, others[n]) for n, array in one.arrays().items())


def run_cases(scenario, worlds, cases, seed=3):
    """Return outcome, steps and path length of each case, straight to the goal."""
    simulator = Simulator(scenario, worlds)
    state, results = simulator.reset(seed, 'validation', cases), {}
    while simulator.active.any():
        state, _, terminated, truncated, info = simulator.step(to_goal(state))
        for world in np.flatnonzero(terminated | truncated):
            case = int(info['case_index'][world])
            assert case not in results
            results[case] = tuple(info[key][world] for key in ('outcome', 'steps', 'path_length'))
    return results


def test_a_case_is_the_same_problem_whatever_the_batch():
    scenario, cases = make_scenario('hard'), range(40)
    alone = run_cases(scenario, 1, cases)
    assert sorted(alone) == list(cases)
    assert alone == run_cases(scenario, 7, cases) == run_cases(scenario, 64, cases)


def test_pedestrians_walk_alike_whatever_an_unseen_robot_does():
    still, moving = (Simulator(make_scenario('simple'), 16, 'disabled') for _ in range(2))
    one = still.reset(seed=1)
    other = moving.reset(seed=1)
    for _ in range(12):
        one = still.step(np.zeros((16, 2)))[0]
        other = moving.step(to_goal(other))[0]
    both = still.active & moving.active
    assert both.sum() > 4
    assert np.array_equal(one.agents.position[both], other.agents.position[both])
    assert not np.allclose(one.robot.position[both], other.robot.position[both])


def test_a_robot_that_is_seen_makes_pedestrians_step_aside():
    positions = []
    for visible in (False, True):
        scenario = dataclasses.replace(make_scenario('crowd20'), robot_visible=visible)
        simulator = Simulator(scenario, 8, autoreset='disabled')
        simulator.reset(seed=1)
        for _ in range(12):
            state = simulator.step(np.zeros((8, 2)))[0]
        positions.append(state.agents.position)
    assert not np.allclose(positions[0], positions[1])


def test_the_oracle_knows_what_the_coming_step_does():
    simulator = Simulator(make_scenario('hard'), 8)
    before = simulator.reset(seed=1)
    expected = before.agents.position + 0.25 * simulator.next_agent_velocities()
    info = simulator.step(np.zeros((8, 2)))[4]
    assert np.array_equal(info['final_state'].agents.position, expected)


def test_the_oracle_is_not_offered_when_the_robot_is_seen():
    scenario = dataclasses.replace(make_scenario('hard'), robot_visible=True)
    simulator = Simulator(scenario)
    simulator.reset()
    with pytest.raises(ConfigError, match='constant_velocity'):
        simulator.next_agent_velocities()


def test_time_out_is_truncation_after_the_time_limit_and_not_termination():
    scenario = dataclasses.replace(make_scenario('simple'), pedestrians=0)
    simulator = Simulator(scenario, 2, autoreset='disabled')
    simulator.reset()
    for step in range(100):
        _, reward, terminated, truncated, info = simulator.step(np.zeros((2, 2)))
        assert (truncated == (step == 99)).all() and not terminated.any()
    assert (info['outcome'] == Outcome.TIMEOUT).all() and (reward == 0).all()
    assert not simulator.active.any()


def test_an_idle_world_stands_still_and_earns_nothing():
    simulator = Simulator(make_scenario('simple'), 3)
    state = simulator.reset(cases=[5])
    assert list(simulator.active) == [True, False, False]
    after, reward, terminated, truncated, info = simulator.step(np.ones((3, 2)))
    assert np.array_equal(after.robot.position[1:], state.robot.position[1:])
    assert not reward[1:].any() and not terminated[1:].any() and not truncated[1:].any()
    assert list(info['active']) == [True, False, False]


def test_automatic_reset_starts_the_next_case_and_keeps_the_final_state():
    simulator = Simulator(make_scenario('crowd20'), 16)
    state = simulator.reset(seed=9)
    done = np.zeros(16, bool)
    while not done.any():
        state, _, terminated, truncated, info = simulator.step(to_goal(state))
        done = terminated | truncated
    assert (state.time[done] == 0).all() and (info['final_state'].time[done] > 0).all()
    assert (simulator.case_index[done] >= 16).all() and (info['case_index'][done] < 16).all()
    assert equal(state.select(~done), info['final_state'].select(~done))


def test_small_steps_lead_pedestrians_where_a_whole_step_does():
    whole, parts = (Simulator(make_scenario('hard'), 4) for _ in range(2))
    whole.reset(seed=4)
    parts.reset(seed=4)
    command = np.full((4, 2), 0.3)
    for _ in range(6):
        one = whole.step(command)[0]
        for _ in range(5):
            other = parts.advance(command, 0.05)[0]
    assert np.allclose(one.agents.position, other.agents.position, atol=1e-9)
    assert np.allclose(one.robot.position, other.robot.position, atol=1e-9)


def test_a_restored_simulator_goes_on_as_if_nothing_had_happened():
    one, other = (Simulator(make_scenario('hard'), 8) for _ in range(2))
    state = one.reset(seed=4, split='train')
    for _ in range(30):
        state = one.step(to_goal(state))[0]
    other.reset(seed=1)
    other.set_state(one.get_state())
    for _ in range(60):
        command = to_goal(state)
        state, reward, *_ = one.step(command)
        copy, same_reward, *_ = other.step(command)
        assert equal(state, copy) and np.array_equal(reward, same_reward)


def test_the_returned_state_is_a_copy():
    simulator = Simulator(make_scenario('simple'), 2)
    state = simulator.reset()
    state.agents.position[:] = 99.0
    assert simulator.state.agents.position.max() < 99.0


def test_arrived_pedestrians_get_another_goal_free_of_obstacles():
    scenario = make_scenario('hard')
    simulator = Simulator(dataclasses.replace(scenario, time_limit=1e6, robot_radius=1e-6), 16)
    simulator.reset(seed=2)
    first = simulator.get_state()['goal'][:, :5]
    outside = np.zeros((16, 2))
    for _ in range(80):
        simulator.step(outside)
    later = simulator.get_state()
    renewed = (later['goal'][:, :5] != first).any(axis=-1)
    assert renewed.mean() > 0.5
    goals = later['goal'][:, :5][renewed]
    obstacles = np.repeat(later['state.agents.position'][:, None, 5:], 5, axis=1)[renewed]
    radii = np.repeat(later['state.agents.radius'][:, None, 5:], 5, axis=1)[renewed]
    gap = np.linalg.norm(goals[:, None] - obstacles, axis=-1) - radii - 0.3
    assert gap.min() > 0.2 - 1e-9


@pytest.mark.parametrize(
    'command', [np.zeros((3, 2)), np.zeros(2), np.full((2, 2), np.nan), np.full((2, 2), -1e18)]
)
def test_a_command_that_is_none_is_refused(command):
    simulator = Simulator(make_scenario('simple'), 2)
    simulator.reset()
    with pytest.raises(ValueError, match='command'):
        simulator.step(command)


def test_only_radii_may_change_between_episodes():
    simulator = Simulator(make_scenario('curriculum-0.3'), 2)
    simulator.change_scenario(make_scenario('curriculum-2.5'))
    assert simulator.reset().agents.radius.max() == 2.5
    with pytest.raises(ConfigError):
        simulator.change_scenario(make_scenario('packed-2.5'))
