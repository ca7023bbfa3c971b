"""The trace is what a run by hand sees."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.evaluation import evaluate
from socialnav_core.metrics.recorder import bodies, ROOM, time_to_collision
from socialnav_core.policies import OrcaPolicy, StraightLinePolicy
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.states import Agents, CrowdState, Robot

HARD = make_scenario('hard')


class Standing(StraightLinePolicy):
    def act(self, state, limits=None):
        return np.zeros((state.batch_size, 2))


def test_the_trace_of_a_case_is_what_a_run_by_hand_sees():
    simulator, policy = Simulator(HARD), OrcaPolicy()
    state = simulator.reset(seed=3, cases=[4])
    states, commands, gaps, ended = [state], [], [], False
    reach = np.hypot(*(state.robot.goal - state.robot.position)[0]) - HARD.goal_tolerance
    while not ended:
        commands.append(policy.act(state)[0])
        state, _, terminated, truncated, info = simulator.step(commands[-1][None])
        states.append(info['final_state'])
        gaps.append((info['clearance'][0], info['pedestrian_clearance'][0]))
        ended = bool(terminated[0] | truncated[0])
    records, end = evaluate(policy, HARD, 6, 3).records, len(commands)
    assert records.steps[4] == end
    assert records.straight_path[4] == pytest.approx(reach)
    moments = [state.time[0] for state in states]
    np.testing.assert_array_equal(records.moment[4, : end + 1], moments)
    for name in ('position', 'velocity'):
        expected = [getattr(state.robot, name)[0] for state in states]
        np.testing.assert_array_equal(getattr(records, name)[4, : end + 1], expected)
    np.testing.assert_array_equal(records.command[4, :end], commands)
    seen = np.column_stack([records.clearance[4, :end], records.pedestrian_clearance[4, :end]])
    np.testing.assert_array_equal(seen, gaps)


def test_behind_the_end_of_an_episode_everything_is_nan_and_nothing_before_it():
    records = evaluate(OrcaPolicy(), HARD, 20, foresight=True).records
    width = records.steps.max()
    for field in dataclasses.fields(records):
        array = getattr(records, field.name)
        if array.ndim == 1:
            continue
        columns = np.arange(array.shape[1])
        last = records.steps + (array.shape[1] == width + 1)
        behind = columns >= last[:, None]
        missing = np.isnan(array.reshape(20, len(columns), -1)).all(axis=-1)
        np.testing.assert_array_equal(missing, behind, field.name)


def test_an_episode_longer_than_the_first_room_is_kept_whole():
    limit = (ROOM + 40) * HARD.time_step
    empty = dataclasses.replace(HARD, pedestrians=0, obstacles=0, time_limit=limit)
    records = evaluate(Standing(), empty, 2).records
    assert (records.steps == ROOM + 40).all()
    assert np.isfinite(records.position).all()
    np.testing.assert_allclose(records.duration, HARD.time_step)


def world(position, velocity, static=False, valid=True):
    """Return a robot at the origin that drives along x at 1 m/s, and one agent; radii 0.3 m."""
    one = np.ones(1)
    robot = Robot(
        np.zeros((1, 2)), np.array([[1.0, 0.0]]), np.zeros(1), 0.3 * one, one, np.ones((1, 2))
    )
    agents = Agents(
        np.array([[position]], float), np.array([[velocity]], float), np.full((1, 1), 0.3),
        np.array([[static]]), np.array([[valid]]),
    )  # fmt: skip
    return bodies(CrowdState(robot, agents, one, np.zeros(1)))


@pytest.mark.parametrize(
    ('position', 'velocity', 'expected'),
    [
        ((5, 0), (0, 0), 4.4),  # the gap of 4.4 m at 1 m/s
        ((5, 0), (-1, 0), 2.2),
        ((5, 0), (1, 0), np.inf),  # as fast ahead
        ((-5, 0), (0, 0), np.inf),  # behind
        ((5, 0.7), (0, 0), np.inf),  # aside
        ((4, -4), (0, 1), 4 - 0.6 / np.sqrt(2)),  # crosses: both reach (4, 0) after 4 s
        ((0.5, 0), (9, 0), 0.0),  # overlaps already
    ],
)
def test_the_time_to_collision_is_when_the_rims_meet(position, velocity, expected):
    assert time_to_collision(world(position, velocity), 0) == pytest.approx(expected)


@pytest.mark.parametrize('kind', [{'static': True}, {'valid': False}])
def test_only_pedestrians_count_for_the_time_to_collision(kind):
    assert time_to_collision(world((5, 0), (0, 0), **kind), 0) == np.inf
