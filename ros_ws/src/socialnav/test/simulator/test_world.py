"""Laws of the simulated world behind the topics."""

import numpy as np
import pytest

from socialnav.simulator.world import World
from socialnav_core.simulation import make_scenario, Simulator

SECOND = 10**9


@pytest.fixture
def world():
    return World(make_scenario('hard'), seed=2, episodes=0, clock=SECOND)


def straight(world):
    """Return a command towards the goal."""
    way = world.state.robot.goal[0] - world.state.robot.position[0]
    angle = -world.state.robot.heading[0]
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return turn @ (way / np.linalg.norm(way))


def run(world, duration):
    """Drive straight until the episode ends."""
    while world.episode is None:
        world.drive(straight(world))
        world.advance(duration)
    return world.episode


def test_commands_are_in_the_frame_of_the_robot(world):
    before = world.state.robot.position[0].copy()
    world.drive(np.array([1.0, 0.0]))
    world.advance(0.25)
    heading = world.state.robot.heading[0]
    expected = before + 0.25 * np.array([np.cos(heading), np.sin(heading)])
    np.testing.assert_allclose(world.state.robot.position[0], expected, atol=1e-12)


def test_the_clock_shows_simulated_time(world):
    before = world.clock
    world.advance(0.25)
    assert world.clock == before + SECOND // 4


def test_the_first_case_follows_the_last_one_that_there_is(world):
    world.begin(world.scenario, 2, 2**32 - 1)
    assert run(world, 0.25).case_index == 2**32 - 1
    world.advance(0.25)
    assert world.case_index == 0 and world.episode is None


@pytest.mark.parametrize('duration', [0.05, 0.07, 0.4])
def test_pedestrians_walk_alike_however_time_is_cut(duration):
    scenario = make_scenario('crowd20')
    world = World(scenario, seed=0, episodes=0, clock=0)
    simulator = Simulator(scenario, batch_size=1, autoreset='disabled')
    state = simulator.reset(seed=0, cases=[0])
    while world.state.time[0] < 2.0 - 1e-9:
        world.advance(min(duration, 2.0 - float(world.state.time[0])))
        assert world.episode is None
    for _ in range(8):
        state = simulator.step(np.zeros((1, 2)))[0]
    np.testing.assert_allclose(world.state.agents.position, state.agents.position, atol=1e-9)


def test_an_answer_to_another_state_is_ignored(world):
    before = world.clock
    assert not world.answer(np.zeros(2), before - 1)
    assert world.clock == before
    assert world.answer(np.zeros(2), before)


def test_the_last_state_of_an_episode_stays_for_one_advance(world):
    assert world.fresh
    episode = run(world, 0.25)
    final = world.state.robot.position.copy()
    assert not world.fresh and episode.case_index == 0
    world.advance(0.25)
    assert world.fresh and world.episode is None
    assert np.linalg.norm(world.state.robot.position - final) > 1.0


def test_the_clock_breaks_between_episodes(world):
    run(world, 0.25)
    end = world.clock
    world.advance(0.25)
    assert world.clock - end == SECOND


def test_cases_follow_each_other_until_all_episodes_are_done():
    world = World(make_scenario('hard'), seed=2, episodes=2, clock=0)
    assert run(world, 0.25).case_index == 0 and not world.done
    world.advance(0.25)
    assert run(world, 0.25).case_index == 1 and world.done
    clock = world.clock
    world.advance(0.25)
    assert world.clock == clock


def test_a_case_that_is_asked_for_begins_at_once_and_counts_anew():
    world = World(make_scenario('hard'), seed=2, episodes=1, clock=0)
    run(world, 0.25)
    world.begin(make_scenario('simple'), seed=5, case_index=7)
    assert not world.done and world.fresh
    episode = run(world, 0.25)
    assert (episode.scenario, episode.seed, episode.case_index) == ('simple', 5, 7)


def test_a_robot_without_commands_brakes(world):
    world.command_timeout = 0.5
    world.drive(np.array([0.1, 0.0]))
    speeds = []
    for _ in range(15):
        world.advance(0.05)
        speeds.append(np.linalg.norm(world.state.robot.velocity))
    assert speeds[9] == pytest.approx(0.1) and speeds[-1] == 0.0


def test_a_paused_world_stands(world):
    world.paused = True
    clock = world.clock
    world.advance(0.25)
    assert not world.answer(np.zeros(2), clock) and world.clock == clock


def test_a_goal_can_be_moved(world):
    world.set_goal(np.array([1.0, 2.0]))
    world.advance(0.25)
    assert world.state.robot.goal[0].tolist() == [1.0, 2.0]
