"""Laws of the one-step look-ahead."""

import numpy as np
import pytest
import torch

from socialnav_core.config import ConfigError, PolicyConfig, ScreeningConfig
from socialnav_core.policies import build_network, observe, ValuePolicy
from socialnav_core.prediction.oracle import attach_simulator
from socialnav_core.simulation import make_scenario, Outcome, Simulator
from socialnav_core.simulation.kinematics import Holonomic


@pytest.fixture(scope='module')
def network():
    torch.manual_seed(1)
    return build_network(PolicyConfig())


def some_state(name='hard', worlds=8, steps=5):
    simulator = Simulator(make_scenario(name), worlds)
    state = simulator.reset(seed=1, split='train')
    for _ in range(steps):
        ahead = state.robot.goal - state.robot.position
        state = simulator.step(0.8 * ahead / np.linalg.norm(ahead, axis=-1, keepdims=True))[0]
    return simulator, state


def test_the_value_of_an_action_is_what_the_simulator_then_does(network):
    """With the oracle the look-ahead and the simulator agree on reward, end and next state."""
    config = PolicyConfig(lookahead='oracle')
    policy = ValuePolicy(network, config)
    simulator, state = some_state()
    attach_simulator(policy.predictor, simulator.next_agent_velocities)
    values = policy.decide(state).values
    memory = simulator.get_state()
    for action, command in enumerate(Holonomic().action_set(config)):
        simulator.set_state(memory)
        _, reward, _, _, info = simulator.step(np.tile(command, (8, 1)))
        seen = observe(info['final_state'])
        with torch.no_grad():
            following = network(*map(torch.from_numpy, (seen.robot, seen.others, seen.mask)))
        going = info['outcome'] == Outcome.NONE
        expected = reward + going * 0.9**0.25 * following.numpy()
        assert np.allclose(values[:, action], expected, atol=1e-5)


def test_constant_velocity_needs_no_oracle_and_the_oracle_no_guess(network):
    _, state = some_state()
    ValuePolicy(network, PolicyConfig()).act(state)
    with pytest.raises(ConfigError, match='constant_velocity'):
        ValuePolicy(network, PolicyConfig(lookahead='oracle')).act(state)


@pytest.mark.parametrize('name', ['sarl', 'gat4sn'])
def test_padding_changes_no_value(name):
    torch.manual_seed(0)
    config = PolicyConfig(network=name)
    policy = ValuePolicy(build_network(config), config)
    _, state = some_state()
    more = state.with_agents(
        position=np.concatenate([state.agents.position, np.full((8, 3, 2), np.nan)], axis=1),
        velocity=np.concatenate([state.agents.velocity, np.full((8, 3, 2), np.nan)], axis=1),
        radius=np.concatenate([state.agents.radius, np.full((8, 3), np.nan)], axis=1),
        static=np.concatenate([state.agents.static, np.zeros((8, 3), bool)], axis=1),
        valid=np.concatenate([state.agents.valid, np.zeros((8, 3), bool)], axis=1),
    )
    assert np.allclose(policy.decide(state).values, policy.decide(more).values, atol=1e-6)


def test_a_world_without_anybody_can_be_decided_in(network):
    _, state = some_state()
    nobody = state.with_agents(
        position=np.zeros((8, 0, 2)),
        velocity=np.zeros((8, 0, 2)),
        radius=np.zeros((8, 0)),
        static=np.zeros((8, 0), bool),
        valid=np.zeros((8, 0), bool),
    )
    policy = ValuePolicy(network, PolicyConfig(screening=ScreeningConfig(enabled=True)))
    assert np.isfinite(policy.act(nobody)).all()


def test_the_commands_do_not_depend_on_the_batch(network):
    policy = ValuePolicy(network, PolicyConfig())
    _, state = some_state(worlds=200)
    together = policy.decide(state).values
    alone = np.concatenate([policy.decide(state.select([i])).values for i in range(0, 200, 20)])
    assert np.allclose(together[::20], alone, atol=1e-5)


def test_a_differential_drive_gets_speeds_and_turn_rates(network):
    config = PolicyConfig(kinematics='differential', max_turn_rate=1.0)
    policy = ValuePolicy(network, config)
    _, state = some_state()
    decision = policy.decide(state)
    assert (decision.commands[..., 0] >= 0).all()
    assert np.abs(decision.commands[..., 1]).max() == 1.0
    assert np.isfinite(decision.values).all()


def test_attention_sums_to_one_over_the_agents(network):
    _, state = some_state()
    weights = ValuePolicy(network, PolicyConfig()).attention(state)
    assert weights.shape == (8, 10)
    assert np.allclose(weights.sum(axis=1), 1.0, atol=1e-5)
