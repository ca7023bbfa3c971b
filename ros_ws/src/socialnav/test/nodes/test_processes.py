"""Laws of processes that die and come back, of the shared memory that they use, and of signals."""

import math
from pathlib import Path
import signal
import sys
import time

from geometry_msgs.msg import Twist
from helpers import stops
from helpers.faults import FAULTS
from helpers.graph import kill
from helpers.managed import change_state, state_of
from helpers.processes import wait_until_loading
from helpers.robot import drives, speed
from helpers.shared_memory import owned_files
from nav_msgs.msg import Odometry
import numpy as np
import pytest

from socialnav import qos
from socialnav.parameters.simulator import SimulatorParameters
from socialnav.programs import INTERRUPTED
from socialnav_core.simulation import make_scenario
from socialnav_msgs.msg import EpisodeResult

pytestmark = pytest.mark.usefixtures('repetition')

PREPARING_NODE = Path(__file__).parents[1] / 'helpers' / 'preparing_node.py'
POLICY = {'model': 'orca', 'bounds': 7.5}
NODES = ('policy_node', 'simulator_node', 'obstacle_node', 'tracker_node')
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
WAY_TO = {
    'unconfigured': (),
    'inactive': ('configure',),
    'active': ('configure', 'activate'),
    'finalized': ('shutdown',),
}
BRAKING = FAULTS['policy killed'].within
"""Time without a command after which the simulated robot brakes, s."""
ALLOWANCE = 0.15
"""Time of a command and of two states, s."""
PREFERRED_SPEED = make_scenario('hard').robot_preferred_speed


@pytest.fixture
def commands(graph):
    """Return the commands that a robot gets."""
    return graph.listen(Twist, 'cmd_vel', qos.COMMAND)


@pytest.fixture
def odometry(graph):
    """Return how the robot moves."""
    return graph.listen(Odometry, 'odom')


def moves(graph, odometry, moving=True):
    """Wait until new odometry says that the robot moves, or stands."""
    odometry.clear()
    graph.wait(
        lambda: odometry and (speed(odometry[-1].twist.twist) > 0.1) == moving,
        'motion' if moving else 'standstill',
    )


def distance(one, other):
    """Return how far apart two places of the robot are, m."""
    here, there = one.pose.pose.position, other.pose.pose.position
    return math.hypot(here.x - there.x, here.y - there.y)


def prepares(graph, folder):
    """Start a policy node and wait until it prepares its model."""
    preparing = folder / 'preparing'
    policy = graph.run([sys.executable, str(PREPARING_NODE), str(preparing)])
    graph.wait(preparing.exists, 'preparation')
    return policy


def end(graph, process, number):
    """End a node with a signal; nothing of it may stay."""
    files = owned_files(process)
    assert files
    graph.kill(process, number)
    graph.wait(lambda: process.poll() is not None, 'end of the process')
    assert process.returncode == 0
    assert not [file for file in files if file.exists()]


def test_a_robot_whose_policy_or_simulator_is_killed_stands_until_there_is_another(
    graph, commands, odometry
):
    assert SimulatorParameters().cmd_vel_timeout == BRAKING
    results = graph.listen(EpisodeResult, 'episode_result', qos.LATCHED_RECORDING)
    simulator = graph.start('simulator_node')
    policy = graph.start('policy_node', **POLICY)
    moves(graph, odometry)
    start, killed = odometry[-1], time.time()
    graph.kill(policy)
    moves(graph, odometry, moving=False)
    # a process that is killed while it publishes may hold up all others, and the world with them
    stops.note('policy killed: the simulated robot stands', time.time() - killed, math.inf)
    assert distance(start, odometry[-1]) < PREFERRED_SPEED * (BRAKING + ALLOWANCE)
    assert not results, 'it stands because its episode is over'
    policy = graph.start('policy_node', **POLICY)
    moves(graph, odometry)
    graph.kill(simulator)
    graph.wait(lambda: speed(commands[-1]) == 0.0, 'stop')
    graph.start('simulator_node')
    moves(graph, odometry)
    end(graph, policy, signal.SIGTERM)
    assert speed(commands[-1]) == 0.0


@pytest.mark.slow
@pytest.mark.parametrize('order', [('simulator', 'policy'), ('policy', 'simulator')])
@pytest.mark.parametrize('lockstep', [False, True])
def test_both_may_be_killed_at_once_and_start_again_in_any_order(graph, odometry, order, lockstep):
    parameters = {'simulator': {'lockstep': lockstep}, 'policy': POLICY | {'lockstep': lockstep}}
    for _ in range(2):
        nodes = []
        for name in order:
            nodes.append(graph.start(f'{name}_node', **parameters[name]))
            graph.spin(1.0)
        moves(graph, odometry)
        for node in nodes:
            graph.kill(node)


def test_a_policy_in_lockstep_drives_on_in_the_world_of_another_simulator(graph, odometry):
    simulator = graph.start('simulator_node', lockstep=True)
    graph.start('policy_node', lockstep=True, **POLICY)
    moves(graph, odometry)
    graph.kill(simulator)
    results = graph.listen(EpisodeResult, 'episode_result', qos.LATCHED_RECORDING)
    graph.start('simulator_node', lockstep=True, episodes=1)
    graph.wait(lambda: results, 'end of an episode')


def test_an_episode_in_lockstep_goes_on_with_another_policy(graph, odometry):
    results = graph.listen(EpisodeResult, 'episode_result', qos.LATCHED_RECORDING)
    graph.start('simulator_node', lockstep=True, episodes=1, scenario='crowd20')
    policy = graph.start('policy_node', lockstep=True, model='orca', scenario='crowd20')
    graph.wait(lambda: len(odometry) > 5, 'first steps')
    graph.kill(policy)
    assert not results
    graph.start('policy_node', lockstep=True, model='orca', scenario='crowd20')
    graph.wait(lambda: results, 'end of the episode')


@pytest.mark.parametrize('number', SIGNALS)
@pytest.mark.parametrize('name', [*NODES, 'demo'])
def test_a_signal_while_a_program_is_still_being_loaded_ends_it_without_a_word(
    graph, name, number
):
    process = graph.start(name)
    wait_until_loading(process, name)
    graph.kill(process, number)
    assert process.wait() == (INTERRUPTED if name == 'demo' else 0)
    assert process.stderr.read() == ''


@pytest.mark.parametrize(
    'number', [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.slow)]
)
def test_a_signal_while_the_model_is_being_prepared_is_obeyed_before_the_robot_moves(
    graph, commands, number, tmp_path
):
    graph.start('simulator_node')
    policy = prepares(graph, tmp_path)
    end(graph, policy, number)
    graph.spin(0.3)
    assert not any(map(speed, commands))


def test_signals_that_interrupt_each_other_end_a_node_as_one_does(graph, tmp_path):
    policy = prepares(graph, tmp_path)
    for pause in np.linspace(0.0, 1e-4, 2000):
        for number in SIGNALS:
            kill(policy, number)
            time.sleep(pause)
    end(graph, policy, signal.SIGINT)


@pytest.mark.slow
@pytest.mark.parametrize('number', SIGNALS)
@pytest.mark.parametrize('label', WAY_TO)
def test_a_signal_in_any_state_is_obeyed_with_exit_code_0_and_leaves_nothing(
    graph, commands, label, number
):
    end_simulator = graph.start('simulator_node')
    policy = graph.start('policy_node', autostart=False, **POLICY)
    for transition in WAY_TO[label]:
        assert change_state(graph, transition)
    assert state_of(graph) == label
    if label == 'active':
        drives(graph, commands)
    end(graph, policy, number)
    graph.spin(0.3)
    assert not any(map(speed, commands[-1:])) and bool(commands) == (label == 'active')
    end(graph, end_simulator, number)
