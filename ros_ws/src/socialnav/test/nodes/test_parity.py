"""The same cases offline and through the graph."""

import dataclasses

from ament_index_python.packages import get_package_share_directory
from nav_msgs.msg import Odometry
import numpy as np
import pytest
import torch

from socialnav import qos
from socialnav.messages.stamps import nanoseconds_of
from socialnav_core.config import Config, PolicyConfig
from socialnav_core.messages.results import COARSE_OUTCOMES
from socialnav_core.policies import build_network, load_policy
from socialnav_core.policies.loading import suited
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.simulation import make_scenario, Outcome, Simulator
from socialnav_msgs.msg import EpisodeResult

FEW = 5
CASES = 20
MANY = 100
SEED = 11
TRAINED = f'{get_package_share_directory("socialnav")}/models/gat4sn'


def offline(policy, scenario, case):
    """Run a case without the middleware; return outcome, steps and final position."""
    simulator = Simulator(scenario, batch_size=1, autoreset='disabled')
    state, ended = simulator.reset(seed=SEED, cases=[case]), False
    policy.reset()
    while not ended:
        state, _, terminated, truncated, info = simulator.step(policy.act(state))
        ended = bool(terminated[0] or truncated[0])
    outcome = Outcome(int(info['outcome'][0])).name.lower()
    return COARSE_OUTCOMES.get(outcome, outcome), int(info['steps'][0]), state.robot.position[0]


@pytest.fixture(scope='module')
def untrained(tmp_path_factory):
    """Return a checkpoint whose weights are random: it drives badly, but always alike."""
    folder = tmp_path_factory.mktemp('untrained')
    policy = PolicyConfig(network='gat4sn')
    torch.manual_seed(0)
    config = Config('untrained', make_scenario('hard'), policy=policy)
    save_weights(folder, build_network(policy), config)
    return str(folder)


def test_an_untrained_network_ends_alike_too(graph, untrained):
    compare(graph, untrained, 'hard', FEW)


@pytest.mark.parametrize(
    ('model', 'scenario', 'cases'),
    [
        ('orca', 'hard', CASES),
        ('orca', 'crowd20', CASES),
        ('search', 'hard', FEW),
        pytest.param(TRAINED, 'hard', CASES, id='gat4sn-hard'),
        pytest.param('orca', 'hard', MANY, marks=pytest.mark.slow),
        pytest.param(TRAINED, 'hard', MANY, marks=pytest.mark.slow, id='many'),
    ],
)
def test_a_case_ends_alike_offline_and_through_the_graph(graph, model, scenario, cases):
    compare(graph, model, scenario, cases)


def test_a_differential_drive_arrives_by_the_default_model_as_it_does_offline(graph):
    policy = load_policy('socialnav_diff_drive', **{'differential.reverse': 0.0})
    results = compare(graph, 'auto', 'hard', FEW, 'differential', policy)
    assert [result.outcome for result in results].count('goal') >= FEW - 1


def compare(graph, model, scenario, cases, kinematics='holonomic', policy=None):
    """
    Run cases both ways, compare how they end and return their results.

    :param policy: what the node is taken to drive by; None: the model as it is.
    """
    results = graph.listen(EpisodeResult, 'episode_result', qos.LATCHED_RECORDING)
    odometry = graph.listen(Odometry, 'odom')
    graph.start('simulator_node', lockstep=True, scenario=scenario, seed=SEED, episodes=cases,
                kinematics=kinematics)  # fmt: skip
    graph.start(
        'policy_node', lockstep=True, scenario=scenario, model=model, kinematics=kinematics
    )
    graph.wait(lambda: len(results) == cases, 'end of the episodes', deadline=250.0)
    graph.spin(0.2)
    final = {nanoseconds_of(one.header.stamp): one.pose.pose.position for one in odometry}
    torch.set_num_threads(1)  # as in the node
    policy = policy or load_policy(model, **suited(model, kinematics))
    world = dataclasses.replace(make_scenario(scenario), kinematics=kinematics)
    for case, result in enumerate(results):
        outcome, steps, position = offline(policy, world, case)
        assert (result.case_index, result.outcome, result.steps) == (case, outcome, steps)
        place = final[nanoseconds_of(result.header.stamp)]
        np.testing.assert_allclose([place.x, place.y], position, rtol=0, atol=1e-6)
    return results
