"""Laws of the policy node as a managed node, over the middleware."""

import pickle
import signal

from geometry_msgs.msg import Twist
from helpers.faults import FAULTS
from helpers.managed import change_parameter, change_state, DOUBLE, state_of, TEXT
from helpers.robot import drives, speed
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
import pytest

from socialnav import qos
from socialnav_core.config import Config
from socialnav_core.policies import build_network
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.simulation import make_scenario


@pytest.fixture
def commands(graph):
    """Return the commands of a robot that is about to drive in a simulated crowd."""
    graph.start('simulator_node')
    return graph.listen(Twist, 'cmd_vel', qos.COMMAND)


def end(graph, process, number=signal.SIGINT):
    """End a node with a signal; return what it printed."""
    graph.kill(process, number)
    graph.wait(lambda: process.poll() is not None, 'end of the process')
    assert process.returncode == 0
    return process.stderr.read()


def test_a_node_without_autostart_waits_in_every_state_until_it_is_told(graph, commands):
    policy = graph.start('policy_node', model='orca', bounds=7.5, autostart=False)
    assert state_of(graph) == 'unconfigured'
    assert change_state(graph, 'configure') and state_of(graph) == 'inactive'
    graph.spin(0.5)
    assert not commands
    assert change_state(graph, 'activate')
    drives(graph, commands)
    assert change_state(graph, 'deactivate') and change_state(graph, 'cleanup')
    assert state_of(graph) == 'unconfigured'
    assert change_state(graph, 'shutdown') and state_of(graph) == 'finalized'
    assert end(graph, policy).count('\n') <= 1


def test_deactivation_ends_with_a_zero_command_and_activation_drives_on(graph, commands):
    graph.start('policy_node', model='orca', bounds=7.5)
    drives(graph, commands)
    assert change_state(graph, 'deactivate')
    graph.spin(0.3)
    count = len(commands)
    assert speed(commands[-1]) == 0.0
    graph.spin(0.5)
    assert len(commands) == count
    assert change_state(graph, 'activate')
    drives(graph, commands)


def test_shutdown_while_driving_ends_with_a_zero_command(graph, commands):
    policy = graph.start('policy_node', model='orca', bounds=7.5)
    drives(graph, commands)
    assert change_state(graph, 'shutdown')
    graph.spin(0.3)
    assert speed(commands[-1]) == 0.0 and state_of(graph) == 'finalized'
    end(graph, policy)


@pytest.mark.parametrize(
    ('label', 'number'), [('unconfigured', signal.SIGINT), ('inactive', signal.SIGTERM)]
)
def test_a_signal_ends_a_node_that_does_not_drive_with_exit_code_0(graph, label, number):
    policy = graph.start('policy_node', model='orca', autostart=False)
    if label == 'inactive':
        assert change_state(graph, 'configure')
    assert state_of(graph) == label
    end(graph, policy, number)


def test_an_impossible_transition_is_answered_and_does_not_end_the_node(graph, commands):
    policy = graph.start('policy_node', model='orca', bounds=7.5)
    drives(graph, commands)
    for wrong in ({'id': Transition.TRANSITION_CONFIGURE}, {'id': 200}, {'label': 'nonsense'}):
        request = ChangeState.Request(transition=Transition(**wrong))
        assert not graph.call(ChangeState, 'policy_node/change_state', request).success
    drives(graph, commands)
    assert FAULTS['impossible transition'].said in end(graph, policy)


def test_model_and_kinematics_change_while_inactive_and_count_from_then_on(graph, commands):
    policy = graph.start('policy_node', model='straight_line', bounds=7.5)
    drives(graph, commands)
    assert change_state(graph, 'deactivate')
    assert change_parameter(graph, 'model', type=TEXT, string_value='nobody').successful
    assert not change_state(graph, 'activate') and state_of(graph) == 'inactive'
    assert change_parameter(graph, 'model', type=TEXT, string_value='orca').successful
    assert change_parameter(graph, 'max_speed', type=DOUBLE, double_value=0.3).successful
    assert change_state(graph, 'activate')
    graph.spin(0.1)
    commands.clear()
    graph.wait(lambda: commands and speed(commands[-1]) == pytest.approx(0.3), 'motion')
    assert "no model 'nobody'" in end(graph, policy)


def missing(folder):
    """Remove the weights."""
    (folder / 'weights.safetensors').unlink()


def truncated(folder):
    """Cut the weights."""
    weights = folder / 'weights.safetensors'
    weights.write_bytes(weights.read_bytes()[:-100])


def altered(folder):
    """Change one bit of the weights."""
    weights = folder / 'weights.safetensors'
    content = bytearray(weights.read_bytes())
    content[-1] ^= 1
    weights.write_bytes(bytes(content))


def mismatching(folder):
    """Give the weights another network's config."""
    config = folder / 'config.yaml'
    config.write_text(config.read_text().replace('sarl', 'gat4sn'))


def garbage(folder):
    """Write noise instead of weights."""
    (folder / 'weights.safetensors').write_bytes(bytes(range(256)) * 64)


def empty(folder):
    """Write weights of no length."""
    (folder / 'weights.safetensors').write_bytes(b'')


def disguised(folder):
    """Write a pickle instead of weights; loading it would leave a trace."""

    class Trap:
        def __reduce__(self):
            return (open, (str(folder / 'sprung'), 'w'))

    (folder / 'weights.safetensors').write_bytes(pickle.dumps(Trap()))


def obscure(folder):
    """Write noise instead of the config."""
    (folder / 'config.yaml').write_bytes(bytes(range(256)) * 64)


def programmed(folder):
    """Write a config that is a program; loading it would leave a trace."""
    trap = f"!!python/object/apply:builtins.open ['{folder / 'sprung'}', 'w']"
    (folder / 'config.yaml').write_text(f'name: {trap}\n')


DAMAGES = (
    missing, truncated, altered, mismatching, garbage, empty, disguised, obscure, programmed,
)  # fmt: skip


def test_a_damaged_model_leaves_the_node_unconfigured_with_one_line(graph, tmp_path):
    policy = graph.start('policy_node', autostart=False)
    config = Config('damaged', make_scenario('hard'))
    network = build_network(config.policy)
    for damage in DAMAGES:
        folder = tmp_path / damage.__name__
        save_weights(folder, network, config)
        damage(folder)
        assert change_parameter(graph, 'model', type=TEXT, string_value=str(folder)).successful
        assert not change_state(graph, 'configure'), damage
        assert not (folder / 'sprung').exists()
    assert state_of(graph) == 'unconfigured'
    errors = end(graph, policy).splitlines()
    for damage, line in zip(DAMAGES, errors, strict=True):
        assert str(tmp_path / damage.__name__) in line


@pytest.mark.parametrize(
    ('parameters', 'text'),
    [
        ({'model': 'nobody'}, "no model 'nobody'"),
        ({'model': 'orca', 'kinematics': 'differential'}, 'holonomic'),
        ({'model': 'orca', 'lockstep': True, 'scenario': 'hart'}, 'did you mean hard'),
    ],
)
def test_a_robot_that_the_model_cannot_drive_leaves_the_node_unconfigured(graph, parameters, text):
    policy = graph.start('policy_node', **parameters)
    assert state_of(graph) == 'unconfigured'
    errors = end(graph, policy)
    assert text in errors and errors.count('\n') == 1
