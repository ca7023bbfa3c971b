"""Laws of the environments for Gymnasium."""

import warnings

import gymnasium
from gymnasium.utils.env_checker import check_env
import numpy as np
import pytest

from socialnav_core import environments
from socialnav_core.config import ConfigError
from socialnav_core.policies import load_policy
from socialnav_core.simulation import make_scenario, Outcome, Simulator

NAME = environments.NAME
TO_GOAL = np.array([1.0, 0.0], np.float32)


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
def test_gymnasium_finds_nothing_wrong(kinematics):
    env = gymnasium.make(NAME, scenario='hard', kinematics=kinematics)
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        warnings.filterwarnings('ignore', message='.*(infinity|render).*')
        check_env(env.unwrapped, skip_render_check=True)


def test_the_first_action_leads_straight_to_the_goal():
    env = gymnasium.make(NAME, scenario='circle', pedestrians=0)
    seen, _ = env.reset(seed=1)
    ended, distances = False, [seen['robot'][0]]
    while not ended:
        seen, _, terminated, truncated, info = env.step(TO_GOAL)
        distances.append(seen['robot'][0])
        ended = terminated or truncated
    assert terminated and info['is_success'] and info['outcome'] == Outcome.GOAL
    np.testing.assert_allclose(np.diff(distances), -0.25, atol=1e-5)


def test_an_action_is_cut_to_the_preferred_speed():
    env = gymnasium.make(NAME, scenario='circle', pedestrians=0).unwrapped
    env.reset(seed=1)
    seen, *_ = env.step(np.array([1.0, 1.0], np.float32))
    assert np.hypot(*seen['robot'][4:6]) == pytest.approx(1.0, abs=1e-5)


def test_a_differential_drive_turns_at_the_rate_of_the_action():
    env = gymnasium.make(
        NAME, scenario='circle', pedestrians=0, kinematics='differential', max_turn_rate=2.0
    ).unwrapped
    before, _ = env.reset(seed=1)
    seen, *_ = env.step(np.array([0.0, 0.5], np.float32))
    turned = (seen['robot'][2] - before['robot'][2] + np.pi) % (2 * np.pi) - np.pi
    assert turned == pytest.approx(0.25 * 0.5 * 2.0, abs=1e-5)


def test_episodes_are_the_cases_of_the_simulator():
    env = gymnasium.make(NAME, scenario='hard', split='validation')
    _, info = env.reset(seed=5)
    assert info['case_index'] == 0
    seen, info = env.reset()
    assert info['case_index'] == 1
    state = Simulator(make_scenario('hard')).reset(5, 'validation', [1])
    distance = np.hypot(*(state.robot.goal - state.robot.position)[0])
    assert seen['robot'][0] == pytest.approx(distance, rel=1e-6)
    again, _ = env.reset(seed=5, options={'case': 1})
    np.testing.assert_array_equal(again['others'], seen['others'])


def test_many_worlds_are_the_same_as_each_alone():
    many = gymnasium.make_vec(NAME, num_envs=3, scenario='hard')
    one = gymnasium.make(NAME, scenario='hard')
    together, _ = many.reset(seed=2)
    actions = many.action_space
    actions.seed(3)
    steps = [actions.sample() for _ in range(5)]
    alone = [one.reset(seed=2, options={'case': case})[0] for case in range(3)]
    for case in range(3):
        np.testing.assert_array_equal(together['others'][case], alone[case]['others'])
    trace = [many.step(action) for action in steps]
    for case in range(3):
        one.reset(seed=2, options={'case': case})
        for number, action in enumerate(steps):
            seen, reward, terminated, truncated, _ = one.step(action[case])
            assert reward == pytest.approx(trace[number][1][case])
            assert terminated == trace[number][2][case]
            if terminated or truncated:
                break
            np.testing.assert_allclose(seen['robot'], trace[number][0]['robot'][case], rtol=1e-6)


def test_a_world_that_ends_begins_anew_and_tells_what_was_seen_last():
    many = gymnasium.make_vec(NAME, num_envs=4, scenario='simple', time_limit=1.0)
    first, _ = many.reset(seed=0)
    for _ in range(4):
        seen, _, terminated, truncated, infos = many.step(np.tile(TO_GOAL, (4, 1)))
    ended = terminated | truncated
    assert ended.all() and infos['_final_obs'].all()
    assert (infos['case_index'] == np.arange(4)).all()
    driven = first['robot'][:, 0] - infos['final_obs']['robot'][:, 0]
    np.testing.assert_allclose(driven[truncated], 1.0, atol=1e-5)
    fresh = Simulator(make_scenario('simple'), 4).reset(0, 'train', [4, 5, 6, 7]).robot
    distance = np.hypot(*(fresh.goal - fresh.position).T)
    np.testing.assert_allclose(seen['robot'][:, 0], distance, rtol=1e-6)
    assert many.observation_space.contains(seen)
    assert many.metadata['autoreset_mode'] is gymnasium.vector.AutoresetMode.SAME_STEP


def test_observations_are_not_written_to_later():
    many = gymnasium.make_vec(NAME, num_envs=2, scenario='crowd20')
    first, _ = many.reset(seed=0)
    kept = {name: array.copy() for name, array in first.items()}
    many.step(np.ones((2, 2), np.float32))
    for name, array in first.items():
        np.testing.assert_array_equal(array, kept[name])


@pytest.mark.parametrize(('slots', 'real'), [(4, 4), (12, 10)])
def test_the_nearest_agents_fill_the_slots(slots, real):
    env = gymnasium.make(NAME, scenario='hard', agents=slots)
    seen, _ = env.reset(seed=0)
    assert seen['others'].shape == (slots, 7) and seen['mask'].sum() == real
    assert (seen['others'][seen['mask'] == 0] == 0).all()


def test_a_policy_of_the_project_can_be_written_as_actions():
    """Straight_line's command is the action (1, 0)."""
    env = gymnasium.make(NAME, scenario='hard').unwrapped
    env.reset(seed=4)
    state = env._simulator.state
    command = load_policy('straight_line').act(state)
    np.testing.assert_allclose(env._interface.command(state, TO_GOAL[None]), command, atol=1e-9)


@pytest.mark.parametrize(
    ('wrong', 'message'),
    [
        ({'scenario': 'nowhere'}, 'unknown scenario'),
        ({'pedestrian': 3}, 'pedestrian'),
        ({'agents': 0}, 'at least 1'),
        ({'max_turn_rate': float('nan')}, 'max_turn_rate'),
    ],
)
def test_what_makes_no_sense_is_refused(wrong, message):
    with pytest.raises(ConfigError, match=message):
        environments.SocialNavEnv(**wrong)


def test_an_action_that_is_not_finite_is_refused():
    env = environments.SocialNavEnv()
    env.reset(seed=0)
    with pytest.raises(ValueError, match='finite'):
        env.step(np.array([np.nan, 0.0]))
