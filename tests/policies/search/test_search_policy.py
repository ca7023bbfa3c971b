"""Laws of the search as a policy."""

import dataclasses

import numpy as np
import pytest

from socialnav_core.config import ConfigError, make_scenario, SearchConfig
from socialnav_core.policies import load_policy, SearchPolicy
from socialnav_core.prediction.protocol import Prediction
from socialnav_core.simulation import Simulator
from socialnav_core.states import mapped
from tests.policies.search.search_worlds import discs, distance_to_goal, drive, gaps, STEP, world


@pytest.fixture(scope='module')
def policy():
    return SearchPolicy()


def crowd(name='hard', worlds=6, steps=6):
    """Return worlds of a scenario after some steps."""
    simulator = Simulator(make_scenario(name), worlds)
    state, policy = simulator.reset(seed=2, split='train'), load_policy('orca')
    for _ in range(steps):
        state, *_ = simulator.step(policy.act(state))
    return state


@pytest.mark.parametrize('tolerance', [0.1, 0.15, 0.3, 0.5])
@pytest.mark.parametrize('speed', [0.3, 1.0, 1.5])
@pytest.mark.parametrize('goal', [(0.0, 0.6), (3.1, -4.2), (30.0, 40.0)])
def test_alone_it_takes_the_time_of_the_straight_line(policy, goal, speed, tolerance):
    states = drive(policy, world(goal=goal, speed=speed), tolerance, steps=700)
    assert distance_to_goal(states[-1]) < tolerance
    least = (np.hypot(*goal) - tolerance) / speed
    assert (len(states) - 1) * STEP <= 1.03 * least + STEP


def test_alone_it_drives_straight(policy):
    states = drive(policy, world(goal=(7.0, 2.9)))
    headings = [np.arctan2(*state.robot.velocity[0, ::-1]) for state in states[1:]]
    assert np.ptp(headings) < 1e-6


def test_it_turns_less_where_turning_costs():
    def turned(turning):
        policy = SearchPolicy(SearchConfig(turning=turning))
        states = drive(policy, world(discs((4.0, 0.1, 0.3)), goal=(8.0, 1.0)))
        velocity = np.concatenate([state.robot.velocity for state in states[1:]])
        return np.abs(np.diff(np.unwrap(np.arctan2(velocity[:, 1], velocity[:, 0])))).sum()

    assert turned(0.1) < turned(0.0)


@pytest.mark.parametrize('step', [0.1, 0.5])
def test_other_time_steps_arrive_as_well(step):
    policy = SearchPolicy(SearchConfig(time_step=step))
    states = drive(policy, world(goal=(3.0, 1.0)), 0.15, steps=60, step=step)
    assert (len(states) - 1) * step <= 1.03 * np.hypot(3.0, 1.0) + step


def test_at_the_goal_it_stays(policy):
    assert np.allclose(policy.act(world(goal=(0.0, 0.0))), 0.0)


@pytest.mark.parametrize('speed', [0.3, 1.0, 1.5])
@pytest.mark.parametrize('name', ['hard', 'crowd20'])
def test_no_command_is_faster_than_the_preferred_speed(policy, name, speed):
    state = crowd(name)
    state = state.with_robot(preferred_speed=np.full(state.batch_size, speed))
    assert np.hypot(*policy.act(state).T).max() <= speed * (1 + 1e-9)


@pytest.mark.parametrize('radius', [0.1, 0.5, 3.0])
def test_it_drives_around_an_obstacle_without_touching_it(policy, radius):
    obstacle = discs((5.0, 0.05, radius), static=True)
    states = drive(policy, world(obstacle, goal=(10.0, 0.0)), steps=80)
    assert distance_to_goal(states[-1]) < 0.3
    assert min(gaps(state).min() for state in states) >= 0.0


def test_it_leaves_an_obstacle_that_it_overlaps(policy):
    states = drive(policy, world(discs((0.5, 0.0, 0.5), static=True), goal=(5.0, 0.0)), steps=40)
    overlaps = [gaps(state)[0] for state in states]
    assert overlaps[0] < 0.0 and overlaps[1] > overlaps[0]
    assert distance_to_goal(states[-1]) < 0.3


def test_it_leaves_somebody_whom_it_overlaps(policy):
    states = drive(policy, world(discs((0.4, 0.0, 0.3)), goal=(5.0, 0.0)), steps=60)
    assert gaps(states[1])[0] > gaps(states[0])[0]
    assert distance_to_goal(states[-1]) < 0.3


def test_a_goal_inside_an_obstacle_is_approached_as_near_as_can_be(policy):
    states = drive(policy, world(discs((5.0, 0.0, 1.0), static=True), goal=(4.8, 0.0)), steps=40)
    assert gaps(states[-1])[0] < 0.3
    assert min(gaps(state)[0] for state in states) >= 0.0


def test_a_goal_in_the_margin_of_an_obstacle_is_reached(policy):
    obstacle = discs((5.0, 0.0, 1.0), static=True)
    states = drive(policy, world(obstacle, goal=(3.69, 0.0)), tolerance=0.1, steps=40)
    assert distance_to_goal(states[-1]) < 0.1


def test_walls_are_not_crossed_and_who_is_beyond_comes_back(policy):
    states = drive(policy, world(discs((0.0, 2.0, 1.5), static=True), start=(-2.5, 2.0),
                                 goal=(2.5, 2.0), bounds=4.0), steps=60)  # fmt: skip
    assert distance_to_goal(states[-1]) < 0.3
    assert max(np.abs(state.robot.position).max() for state in states) <= 3.7
    assert policy.act(world(start=(4.5, 0.0), goal=(0.0, 0.0), bounds=4.0))[0, 0] < -0.9


@pytest.mark.parametrize('offset', [0.0, 0.2])
def test_somebody_who_walks_head_on_is_passed(policy, offset):
    walker = discs((6.0, offset, 0.3), velocity=[(-1.0, 0.0)])
    states = drive(policy, world(walker, goal=(8.0, 0.0)), steps=50)
    assert distance_to_goal(states[-1]) < 0.3
    assert min(gaps(state)[0] for state in states) > 0.1
    assert len(states) * STEP < 1.15 * 7.7


class Doubtful:
    """Keeps everybody where they are, and doubts it."""

    knowledge = 'deployable'
    remembers = False

    def __init__(self, deviation):
        self.deviation = deviation

    def predict(self, state, times):
        position = state.agents.position
        shape = (state.batch_size, 1, len(times), state.agents.count)
        positions = np.broadcast_to(position[:, None, None], (*shape, 2))
        weights = np.ones((state.batch_size, 1))
        return Prediction(positions, np.full(shape, self.deviation), weights)

    def reset(self, worlds=None):
        pass


@pytest.mark.parametrize('deviation', [0.5, 1.0, 3.0])
def test_wide_deviations_do_not_freeze_it(deviation):
    people = discs((3.0, 1.2, 0.3), (3.0, -1.2, 0.3), (5.0, 0.4, 0.3))
    states = drive(SearchPolicy(predictor=Doubtful(deviation)), world(people, goal=(8.0, 0.0)))
    assert distance_to_goal(states[-1]) < 0.3
    assert len(states) * STEP < 2 * 8.0


def test_modes_weigh_as_their_probabilities():
    class Split(Doubtful):
        def predict(self, state, times):
            one = super().predict(state, times)
            twice = [np.repeat(a, 2, axis=1) for a in (one.positions, one.deviations)]
            return Prediction(*twice, np.full((state.batch_size, 2), 0.5))

    state = crowd('crowd20')
    one, two = SearchPolicy(predictor=Doubtful(0.1)), SearchPolicy(predictor=Split(0.1))
    assert np.allclose(one.act(state), two.act(state))
    assert np.allclose(one.expected_cost, two.expected_cost)


def test_the_order_of_the_agents_changes_nothing(policy):
    for name in ('hard', 'crowd20'):
        state = crowd(name)
        order = np.random.default_rng(0).permutation(state.agents.count)
        orders = np.tile(order, (state.batch_size, 1))
        permuted = dataclasses.replace(state, agents=state.agents.take(orders))
        assert np.allclose(policy.act(state), policy.act(permuted))


def test_padding_changes_nothing(policy):
    state = crowd()
    padding = mapped(lambda a: a[:, :3].copy(), state.agents)
    padding.position[:] = state.robot.position[:, None]
    padding.valid[:] = False
    padded = dataclasses.replace(state, agents=padding.append(state.agents))
    assert np.array_equal(policy.act(state), policy.act(padded))


def test_a_batch_is_its_worlds_one_by_one(policy):
    for name in ('hard', 'crowd20'):
        state = crowd(name)
        together, alone = policy.act(state), SearchPolicy()
        apart = [alone.act(state.select(np.array([i])))[0] for i in range(state.batch_size)]
        assert np.array_equal(together, apart)


def test_any_number_of_agents_will_do(policy):
    turn = np.linspace(0.0, 2.0 * np.pi, 300, endpoint=False)
    ring = np.stack([3.0 * np.cos(turn), 3.0 * np.sin(turn), np.full(300, 0.01)], axis=-1)
    inside = policy.act(world(discs(*ring, static=True), goal=(8.0, 0.0)))
    assert np.isfinite(inside).all()
    assert np.isfinite(policy.act(world(discs(*ring)))).all()


def test_the_plan_begins_with_the_command_and_keeps_the_speed(policy):
    state = crowd()
    command = policy.act(state)
    assert np.allclose(policy.plan[:, 0], state.robot.position + STEP * command)
    path = np.concatenate([state.robot.position[:, None], policy.plan], axis=1)
    steps = np.linalg.norm(np.diff(path, axis=1), axis=-1)
    assert steps.max() <= STEP * state.robot.preferred_speed.max() * (1 + 1e-9)
    assert policy.plan.shape[1] == len(policy.times)


def test_it_is_found_by_its_name():
    assert isinstance(load_policy('search'), SearchPolicy)


@pytest.mark.parametrize('setting', [
    {'horizon': 0.0}, {'headings': 2}, {'contact_discount': 1.5}, {'time_step': 4.0},
    {'goal_tolerance': -0.1}, {'turning': -1.0},
])  # fmt: skip
def test_settings_that_describe_no_search_are_refused(setting):
    with pytest.raises(ConfigError):
        SearchConfig(**setting)
