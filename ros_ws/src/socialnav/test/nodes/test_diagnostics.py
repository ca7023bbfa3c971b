"""Laws of what operators see and can do, over the middleware."""

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Twist
from helpers.faults import FAULTS
from helpers.managed import change_state
from helpers.robot import drives, speed
import pytest
from std_srvs.srv import Trigger

from socialnav import qos

AGES = {
    'age of odom [s]',
    'age of pedestrians [s]',
    'age of obstacles [s]',
    'age of goal_pose [s]',
}


@pytest.fixture
def health(graph):
    """Return a list that grows with every status of the policy node."""
    messages = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)

    class Health:
        """The statuses that came."""

        def newest(self):
            return messages[-1].status[0] if messages else DiagnosticStatus()

        def wait(self, text):
            graph.wait(lambda: text in self.newest().message, f'diagnosis {text!r}')
            return self.newest()

        def __len__(self):
            return len(messages)

    return Health()


@pytest.fixture
def commands(graph):
    """Return the commands to a robot in a simulated crowd."""
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca', bounds=7.5)
    return commands


def facts_of(status):
    """Return the values of a status by name."""
    return {one.key: one.value for one in status.values}


def test_diagnostics_tell_state_reason_and_what_a_decision_takes(graph, health, commands):
    assert health.wait('no odom').level == DiagnosticStatus.WARN
    graph.start('simulator_node')
    health.wait('driving')
    graph.wait(lambda: facts_of(health.newest()).keys() >= AGES, 'ages')
    status = health.newest()
    facts = facts_of(status)
    assert status.level == DiagnosticStatus.OK and status.name == 'policy_node'
    assert facts['state'] == 'active' and facts['model'] == 'orca'
    assert int(facts['decisions']) > 0 and float(facts['decision time [s]']) > 0.0
    assert facts.keys() >= {'late decisions', 'clamped commands'}
    assert change_state(graph, 'deactivate')
    assert facts_of(health.wait(FAULTS['deactivated'].said))['state'] == 'inactive'


def test_diagnostics_come_every_second_and_at_once_when_the_reason_changes(graph, health):
    graph.start('policy_node', model='orca', autostart=False)
    health.wait('unconfigured')
    count = len(health)
    graph.spin(3.0)
    assert 2 <= len(health) - count <= 4
    count = len(health)
    assert change_state(graph, 'configure')
    assert len(health) > count


def test_diagnostics_tell_why_a_node_is_not_configured(graph, health):
    graph.start('policy_node', model='nobody')
    status = health.wait(FAULTS['model missing'].said + " 'nobody'")
    assert status.level == DiagnosticStatus.ERROR
    assert facts_of(status)['state'] == 'unconfigured'


def test_a_cancelled_goal_stops_the_robot_until_there_is_another(graph, health, commands):
    simulator = graph.start('simulator_node')
    drives(graph, commands)
    assert graph.call(Trigger, 'policy_node/cancel_goal', Trigger.Request()).success
    status = health.wait('no goal_pose')
    assert status.level == DiagnosticStatus.OK
    graph.wait(lambda: speed(commands[-1]) == 0.0, 'stop')
    assert not graph.call(Trigger, 'policy_node/cancel_goal', Trigger.Request()).success
    graph.kill(simulator)
    graph.start('simulator_node')
    drives(graph, commands)


def test_another_publisher_of_commands_is_a_warning_while_the_robot_is_driven(
    graph, health, commands
):
    health.wait('no odom')
    foreign = graph.node.create_publisher(Twist, 'cmd_vel', qos.COMMAND)
    status = health.wait(FAULTS['another publisher'].said + ': /probe')
    assert status.level == DiagnosticStatus.WARN
    assert change_state(graph, 'deactivate')
    assert health.wait('inactive').message == 'inactive'
    graph.node.destroy_publisher(foreign)
    assert change_state(graph, 'activate')
    graph.wait(
        lambda: health.newest().message == 'no odom; nobody publishes /odom', 'end of the warning'
    )
