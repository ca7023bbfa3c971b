"""Laws of the contract that every policy keeps, and of making one with other settings."""

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.mapping import to_mapping
from socialnav_core.evaluation import evaluate
from socialnav_core.policies import load_policy, PolicyDescription, StraightLinePolicy
from socialnav_core.policies.loading import settings_of, WITHOUT_NETWORK, WithoutNetwork
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.viewing import record

HARD = make_scenario('hard')
MODELS = [*WITHOUT_NETWORK, 'sarl', 'gat4sn']


class Remembering(StraightLinePolicy):
    """Counts how long it has driven in each world and drives blindly."""

    description = PolicyDescription('remembering', 'holonomic', remembers=True)

    def __init__(self):
        self.seen = None
        self.longest = 0

    def act(self, state, limits=None):
        if self.seen is None:
            self.seen = np.zeros(state.batch_size)
        self.seen += 1
        self.longest = max(self.longest, self.seen.max())
        return super().act(state, limits)

    def reset(self, worlds=None):
        if worlds is None:
            self.seen = None
        else:
            self.seen[worlds] = 0


@pytest.mark.parametrize('model', MODELS)
def test_every_policy_keeps_the_contract(model):
    policy = load_policy(model)
    state = Simulator(HARD, 3).reset(seed=1)
    policy.reset()
    commands = policy.act(state, Limits(1.0, 1.0, 1.0, 0.25))
    assert commands.shape == (3, 2) and np.isfinite(commands).all()
    weights, plan = policy.attention(state), policy.plan
    assert weights is None or weights.shape == state.agents.valid.shape
    assert plan is None or (plan.shape[0], plan.shape[2]) == (3, 2)
    policy.reset(np.array([1]))
    described = policy.description
    assert described.kinematics == 'holonomic' and described.name
    assert (described.prediction is None) == (policy.predictor is None)
    if policy.predictor is not None:
        assert described.knowledge == policy.predictor.knowledge


def test_a_policy_with_a_memory_is_told_where_a_new_case_begins():
    policy = Remembering()
    records = evaluate(policy, HARD, 9, batch_size=1).records
    assert policy.longest == records.steps.max()


def test_a_policy_with_a_memory_sees_each_world_in_the_same_row_to_the_end():
    policy = Remembering()
    evaluate(policy, HARD, 7, batch_size=3)
    assert policy.seen.shape == (3,)


def test_an_entry_of_the_table_makes_a_policy_that_everything_finds(monkeypatch):
    made = WithoutNetwork(StraightLinePolicy(), lambda settings: Remembering())
    monkeypatch.setitem(WITHOUT_NETWORK, 'remembering', made)
    assert load_policy('remembering').description.name == 'remembering'
    with pytest.raises(ConfigError, match='remembering'):
        load_policy('nobody')


@pytest.mark.parametrize('model', MODELS)
def test_a_setting_that_a_policy_lacks_is_answered_with_those_that_it_has(model):
    with pytest.raises(ConfigError, match=f'{model} has no setting') as error:
        load_policy(model, charm=1.0)
    assert all(name in str(error.value) for name in settings_of(model))


def test_overrides_reach_the_policy_by_their_names():
    policy = load_policy(
        'sarl', lookahead='oracle', screening=True, goal_tolerance=0.2, **{'screening.horizon': 2}
    )
    described, config = policy.description, policy.config
    assert described.look_ahead == 'oracle (oracle)' and described.screening
    assert (config.goal_tolerance, config.screening.horizon) == (0.2, 2.0)
    assert load_policy('orca', safety_space=0.3).description.settings == {'safety_space': 0.3}


def test_an_override_that_is_none_leaves_the_own_setting():
    plain, same = load_policy('sarl'), load_policy('sarl', lookahead=None, screening=None)
    assert plain.config == same.config


def test_a_recording_tells_what_the_prediction_knew():
    assert record(load_policy('sarl'), HARD).look_ahead == 'constant_velocity (deployable)'
    assert record(load_policy('orca'), HARD).look_ahead is None


@pytest.mark.parametrize('model', MODELS)
@pytest.mark.parametrize('number', [np.nan, np.inf])
def test_a_state_that_holds_no_number_is_refused_by_name(model, number):
    policy, state = load_policy(model), Simulator(HARD, 3).reset(seed=1)
    for name, array in state.arrays().items():
        if array.dtype != np.float64 or name == 'time' or (name == 'bounds' and number == np.inf):
            continue
        kept = array[1].copy()
        array[1].flat[-1:] = number if array[1].ndim else 0
        if not array[1].ndim:
            array[1] = number
        with pytest.raises(ValueError, match=f'world 1 of the state: {name} is not finite'):
            policy.act(state)
        array[1] = kept


@pytest.mark.parametrize('model', MODELS)
def test_padding_may_hold_anything(model):
    policy, state = load_policy(model), Simulator(HARD, 3).reset(seed=1)
    state.agents.valid[:, -1] = False
    without = policy.act(state)
    policy.reset()
    state.agents.position[:, -1] = 1e9
    assert np.array_equal(policy.act(state), without)


@pytest.mark.parametrize('model', WITHOUT_NETWORK)
def test_settings_of_a_policy_have_ranges(model):
    for name, value in to_mapping(WITHOUT_NETWORK[model].settings).items():
        if isinstance(value, float):
            for number in (float('nan'), float('inf'), -1.0, 1e9):
                with pytest.raises(ConfigError, match=name):
                    load_policy(model, **{name: number})
