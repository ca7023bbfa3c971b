"""Laws of recorded people in the simulated world."""

import dataclasses
import itertools
from pathlib import Path

import numpy as np
import pytest

from socialnav_core import cli
from socialnav_core.commands.render import write
from socialnav_core.config import ConfigError, make_scenario
from socialnav_core.config.recordings import INTERVAL, read_tracks
from socialnav_core.evaluation import evaluate, find_bounds
from socialnav_core.evaluation.futures import record_futures
from socialnav_core.evaluation.witness import witness_of
from socialnav_core.policies import StraightLinePolicy
from socialnav_core.simulation import Simulator
from socialnav_core.simulation.crowds.recorded import LEAST_GAP
from socialnav_core.simulation.crowds.recorded_reactive import HASTE, NEAR, SLOWEST
from socialnav_core.simulation.recorded import (
    CLEAR_TIME,
    first_moment,
    first_moments,
    is_open,
    replay_of,
)
from socialnav_core.viewing import record

FILE = Path(__file__).parents[2] / 'data' / 'recorded_people.txt'
WORLD = make_scenario(f'recorded:{FILE}')
REACTIVE = make_scenario(f'recorded_reactive:{FILE}')
WORLDS = 6
OUTSIDE = 50.0


def watched(scenario=WORLD, steps=80, robot=OUTSIDE, worlds=WORLDS):
    """Return the states of worlds whose robots stand, far away or where they start."""
    simulator = Simulator(dataclasses.replace(scenario, bounds=1000.0), worlds, 'disabled')
    states = [simulator.reset()]
    if robot is not None:
        simulator._episodes.state.robot.position[:] = robot
    for _ in range(steps):
        states.append(simulator.step(np.zeros((worlds, 2)))[4]['final_state'])
    return states


def test_the_curve_goes_through_what_was_annotated():
    replay = replay_of(dataclasses.replace(WORLD, time_step=0.2))
    tracks = read_tracks(FILE)
    seen = tracks[1:-1][np.isfinite(tracks[1:-1, :, 0])]
    middle = 0.5 * (np.nanmax(tracks, axis=(0, 1)) + np.nanmin(tracks, axis=(0, 1)))
    moments = replay.position[::2][replay.there[::2]] + middle
    apart = np.linalg.norm(moments[:, None] - seen[None], axis=-1).min(axis=1)
    assert len(moments) > 2000 and apart.max() < 1e-9


def test_people_do_in_the_simulator_what_they_did():
    replay, states = replay_of(WORLD), watched()
    begin = [first_moment(WORLD, 'test', 0, case) for case in range(WORLDS)]
    for step, state in enumerate(states):
        for world, first in enumerate(begin):
            there = replay.there[first + step]
            np.testing.assert_array_equal(state.agents.valid[world], there)
            np.testing.assert_allclose(
                state.agents.position[world][there], replay.position[first + step][there],
                atol=1e-9,
            )  # fmt: skip
            np.testing.assert_allclose(
                state.agents.velocity[world][there], replay.velocity[first + step - 1][there],
                atol=1e-9,
            )  # fmt: skip


def test_people_come_and_go_and_who_is_not_there_touches_nobody():
    states = watched()
    valid = np.array([state.agents.valid for state in states])
    assert (valid[1:] & ~valid[:-1]).any() and (valid[:-1] & ~valid[1:]).any()
    state = states[-1].copy()
    gone = ~state.agents.valid
    assert gone.any() and not state.agents.velocity[gone].any()


def test_people_do_not_react_to_the_robot():
    far, near = watched(robot=OUTSIDE), watched(robot=0.0)
    shared = 0
    for before, after in zip(far, near, strict=True):
        both = before.agents.valid & after.agents.valid
        both &= np.isclose(before.time, after.time)[:, None]  # where the robot was not run over
        shared += both.sum()
        np.testing.assert_array_equal(before.agents.position[both], after.agents.position[both])
    assert shared > 500


def test_nobody_appears_near_the_robot_but_everybody_is_there_in_the_futures():
    late = 0
    for robot in np.arange(-6.0, 7.0, 2.0):
        states = watched(robot=(robot, 1.0))
        for before, after in itertools.pairwise(states[1:]):
            came = after.agents.valid & ~before.agents.valid
            gap = np.linalg.norm(after.agents.position - after.robot.position[:, None], axis=-1)
            assert (gap[came] >= LEAST_GAP + 0.6).all()
            going_on = np.isclose(after.time, before.time + WORLD.time_step)
            moments = [first_moment(WORLD, 'test', 0, case) for case in range(WORLDS)]
            there = replay_of(WORLD).there[moments + np.rint(after.time / 0.25).astype(int)]
            late += (there & ~after.agents.valid)[going_on].sum()
    assert late > 0
    futures = record_futures(WORLD, np.arange(WORLDS), 0, 'test')
    for step in range(60):
        there = replay_of(WORLD).there[np.array(moments) + step]
        np.testing.assert_array_equal(futures.position[:, step, :, 0] < 1e5, there)


def test_steps_of_parts_of_a_time_step_lead_to_the_same_people():
    wide = dataclasses.replace(WORLD, bounds=1000.0)
    one, other = (Simulator(wide, 2, 'disabled') for _ in range(2))
    for simulator in (one, other):
        simulator.reset()
        simulator._episodes.state.robot.position[:] = OUTSIDE
    for _ in range(20):
        state = one.step(np.zeros((2, 2)))[4]['final_state']
        for _ in range(5):
            parts = other.advance(np.zeros((2, 2)), 0.05)[4]['final_state']
    np.testing.assert_array_equal(state.agents.valid, parts.agents.valid)
    valid = state.agents.valid
    np.testing.assert_allclose(
        state.agents.position[valid], parts.agents.position[valid], atol=1e-9
    )


def test_a_simulation_of_recorded_people_goes_on_from_its_state():
    one, other = Simulator(WORLD, WORLDS), Simulator(WORLD, WORLDS)
    one.reset()
    other.reset(seed=4)
    for _ in range(10):
        one.step(np.zeros((WORLDS, 2)))
    other.set_state(one.get_state())
    for _ in range(30):
        state, copy = (each.step(np.zeros((WORLDS, 2)))[0] for each in (one, other))
        np.testing.assert_array_equal(state.agents.position, copy.agents.position)
        np.testing.assert_array_equal(state.agents.valid, copy.agents.valid)


def test_splits_share_no_moment_of_the_recording():
    steps = round(WORLD.time_limit / WORLD.time_step)
    spans = [first_moments(WORLD, split) for split in ('train', 'validation', 'test')]
    for earlier, later in itertools.pairwise(spans):
        assert earlier.max() + steps < later.min()


def test_a_case_is_the_same_whatever_is_run_beside_it():
    alone, many = Simulator(WORLD, 1), Simulator(WORLD, 8)
    state, batch = alone.reset(seed=3, cases=[5]), many.reset(seed=3)
    np.testing.assert_array_equal(state.agents.position[0], batch.agents.position[5])
    np.testing.assert_array_equal(state.robot.goal[0], batch.robot.goal[5])
    assert len({tuple(goal) for goal in batch.robot.goal}) == 8


def test_nobody_comes_to_the_robots_start_within_a_second():
    simulator = Simulator(WORLD, 100, 'disabled')
    state = simulator.reset()
    travel = np.linalg.norm(state.robot.goal - state.robot.position, axis=1)
    assert (travel >= WORLD.minimum_travel).all() and (travel <= WORLD.maximum_travel).all()
    for _ in range(round(CLEAR_TIME / WORLD.time_step)):
        info = simulator.step(np.zeros((100, 2)))[4]
        assert (info['pedestrian_clearance'] > 0.1).all()


def test_nobody_stands_on_the_goal_most_of_the_time():
    replay, moment = replay_of(WORLD), round(50 * INTERVAL / WORLD.time_step)
    waiting = np.linalg.norm(replay.velocity[moment], axis=1) < 0.1
    waiting &= replay.there[moment]
    assert waiting.sum() == 1
    (place,) = replay.position[moment][waiting]
    assert not is_open(replay, WORLD, moment, place)
    assert is_open(replay, WORLD, moment, place + 0.5)


def test_a_start_and_a_goal_that_are_chosen_are_taken():
    world = dataclasses.replace(WORLD, robot_start=(-7.0, 0.0), robot_goal=(7.0, 1.0))
    robot = Simulator(world, 5).reset().robot
    assert (robot.position == (-7.0, 0.0)).all() and (robot.goal == (7.0, 1.0)).all()


def test_the_bound_is_driven_in_just_its_time():
    bounds = find_bounds(WORLD, np.arange(5))
    solved = np.flatnonzero(np.isfinite(bounds.comfortable))
    assert len(solved) > 2
    for case in solved:
        driven = record(witness_of(WORLD, int(case)), WORLD, 0, int(case))
        assert driven.outcome == 'goal' and driven.minimum_clearance > 0.2
        assert driven.times[-1] == pytest.approx(bounds.comfortable[case])
    futures = record_futures(WORLD, np.arange(3), 0, 'test')
    assert np.isfinite(futures.position).all() and (futures.position > 1e5).any()


def test_who_reacts_keeps_clear_of_a_robot_that_does_not():
    plain = evaluate(StraightLinePolicy(), WORLD, 40)
    reacting = evaluate(StraightLinePolicy(), REACTIVE, 40)
    assert reacting.success_rate > plain.success_rate + 0.2


def test_who_reacts_does_what_was_recorded_where_the_robot_is_far():
    for before, after in zip(watched(), watched(REACTIVE), strict=True):
        valid = before.agents.valid
        np.testing.assert_array_equal(valid, after.agents.valid)
        np.testing.assert_array_equal(before.agents.position[valid], after.agents.position[valid])


def test_who_left_their_way_finds_back_to_it_without_haste():
    simulator = Simulator(dataclasses.replace(REACTIVE, bounds=1000.0), WORLDS, 'disabled')
    simulator.reset()
    replay, strayed, back = replay_of(REACTIVE), 0.0, []
    for step in range(60):
        if step == 20:
            simulator._episodes.state.robot.position[:] = OUTSIDE
        state = simulator.step(np.zeros((WORLDS, 2)))[4]['final_state']
        active = np.flatnonzero(simulator.active)
        speed = np.linalg.norm(state.agents.velocity[state.agents.valid], axis=1)
        assert speed.max() < HASTE * max(SLOWEST, 2.5)
        for world in active:
            moment = first_moment(REACTIVE, 'test', 0, int(world)) + step + 1
            there = replay.there[moment]
            gap = state.agents.position[world][there] - replay.position[moment][there]
            apart = np.linalg.norm(gap, axis=1).max(initial=0.0)
            strayed = max(strayed, apart)
            back.append(apart) if step == 59 else None
    assert strayed > 0.1 and np.median(back) < 0.1 and NEAR < OUTSIDE


def test_who_reacts_has_no_bound_and_a_changed_file_is_refused(tmp_path):
    with pytest.raises(ConfigError, match='depends on the robot'):
        find_bounds(REACTIVE, np.arange(1))
    copy = tmp_path / 'people.txt'
    copy.write_text(FILE.read_text())
    world = make_scenario(f'recorded:{copy}')
    copy.write_text(FILE.read_text() + '\n2500 99 1 1')
    with pytest.raises(ConfigError, match='is not the file'):
        Simulator(world, 1)


def test_a_recording_that_is_too_short_or_too_full_says_what_to_do():
    with pytest.raises(ConfigError, match='must be longer than time_limit'):
        Simulator(dataclasses.replace(WORLD, time_limit=60.0), 1).reset()
    with pytest.raises(ConfigError, match='pedestrians must be at least'):
        Simulator(dataclasses.replace(WORLD, pedestrians=2), 1)
    with pytest.raises(ConfigError, match='no start and goal'):
        Simulator(dataclasses.replace(WORLD, minimum_travel=14.9), 1).reset()


def test_the_commands_take_a_recording(tmp_path, capsys):
    name = f'recorded:{FILE}'
    picture = tmp_path / 'paths.png'
    for words in (
        ['evaluate', 'straight_line', '--scenario', name, '--episodes', '3', '--bound'],
        ['compare', 'straight_line', 'orca', '--scenario', name, '--episodes', '3'],
        ['bound', '--scenario', name, '--episodes', '2'],
        ['render', 'straight_line', '--scenario', name, '--out', str(picture)],
        ['scenarios', name],
    ):
        assert cli.main(words) == 0, words
    assert picture.exists()
    assert 'crowd: recorded' in capsys.readouterr().out
    slow = ['--set', f'scenario.recording.interval={2 * INTERVAL}']
    words = ['evaluate', 'straight_line', '--scenario', name, '--episodes', '3', *slow]
    assert cli.main(words) == 0


def test_pictures_show_people_only_where_they_are(tmp_path):
    recording = record(StraightLinePolicy(), WORLD, 0, 2)
    valid = np.array([state.agents.valid[0] for state in recording.states])
    assert not valid.all(axis=0)[valid.any(axis=0)].all()
    np.testing.assert_array_equal(np.isfinite(recording.agent_paths[..., 0]), valid)
    for ending in ('gif', 'png'):
        write(recording, tmp_path / f'case.{ending}')
        assert (tmp_path / f'case.{ending}').stat().st_size > 10_000
