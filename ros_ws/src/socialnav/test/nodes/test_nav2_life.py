"""Laws of the policy node in the place of nav2's controller_server, over the middleware."""

from pathlib import Path
from types import SimpleNamespace

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TwistStamped
from helpers.graph import open_graph
from helpers.managed import change_state, state_of
from helpers.nav2_interfaces import nav2_interfaces
from helpers.path_client import Base, line, PathClient
from helpers.robot import speed
import pytest

from socialnav import qos
from socialnav.control.following import Code
from socialnav.demo.children import command_line

NODE = 'robot/controller_server'
RENAMED = ('-r', '__node:=controller_server', '-r', '__ns:=/robot')
"""What nav2's launch files tell a controller_server of a robot in a namespace."""
SHARED = [item for name in ('odom', 'pedestrians', 'obstacles')
          for item in ('-r', f'{name}:=/{name}')]  # fmt: skip
README = Path(__file__).parents[2] / 'README.md'
SIGNS = 15
"""Signs of life that are waited for."""


def start(graph, folder, *options, **parameters):
    """Start a policy node; return the file of its log."""
    command = command_line('policy_node', {'model': 'straight_line'} | parameters)
    graph.run([*command, '--log-level', 'info', *options], log=folder / 'log')
    return folder / 'log'


@pytest.fixture(scope='module')
def stack(tmp_path_factory):
    """Yield a policy node under a manager, in the place of controller_server, and its client."""
    with nav2_interfaces(), open_graph() as graph:
        start(
            graph, tmp_path_factory.mktemp('log'), *RENAMED, *SHARED,
            '-r', 'cmd_vel:=cmd_vel_nav', autostart=False, goal_topics=False,
            enable_stamped_cmd_vel=True,
        )  # fmt: skip
        client = PathClient(graph, 'robot/follow_path')
        commands = graph.listen(TwistStamped, 'robot/cmd_vel_nav', qos.COMMAND)
        yield SimpleNamespace(graph=graph, client=client, commands=commands, base=Base(graph))


def test_a_manager_that_counts_on_signs_of_life_gets_them_while_the_node_is_active(stack):
    from bond.msg import Status

    graph, signs = stack.graph, stack.graph.listen(Status, 'robot/bond', qos.BOND)
    assert change_state(graph, 'configure', NODE)
    graph.spin(0.3)
    assert not signs
    for _ in range(2):
        assert change_state(graph, 'activate', NODE) and state_of(graph, NODE) == 'active'
        graph.wait(lambda: len(signs) >= SIGNS, 'signs of life')
        assert all(one.active and one.id == 'controller_server' for one in signs)
        assert len({one.instance_id for one in signs}) == 1
        lasted = moment(signs[-1]) - moment(signs[0])
        assert lasted / (len(signs) - 1) == pytest.approx(0.1, abs=0.05)
        assert change_state(graph, 'deactivate', NODE)
        graph.wait(lambda: not signs[-1].active, 'last sign')
        signs.clear()
        graph.spin(0.3)
        assert not signs


def moment(sign):
    """Return when a sign of life was given, s."""
    return sign.header.stamp.sec + sign.header.stamp.nanosec * 1e-9


def test_only_an_active_node_accepts_paths_and_before_the_first_one_it_is_silent(stack):
    graph, client = stack.graph, stack.client
    client.wait()
    assert not client.send(line((0, 0), (2, 0))).handle.accepted
    assert change_state(graph, 'activate', NODE)
    stack.commands.clear()
    graph.spin(0.5)
    assert not stack.commands
    known = client.send(line((0, 0), (2, 0)))
    graph.wait(lambda: stack.commands and speed(stack.commands[-1].twist) > 0.5, 'motion')
    command = stack.commands[-1]
    assert command.header.frame_id == 'base_link' and command.header.stamp.sec
    assert client.cancel(known) and client.outcome(known)[1:] == (0, 'cancelled')


def test_where_only_paths_count_nobody_listens_to_goals_and_plans(stack):
    node = stack.graph.node
    stack.graph.wait(lambda: node.count_subscribers('robot/speed_limit'), 'node')
    assert not node.count_subscribers('robot/goal_pose')
    assert not node.count_subscribers('robot/plan')


def test_the_readme_tells_what_is_there_with_nav2(stack):
    graph = stack.graph
    rows = README.read_text()
    for direction, topic, kind in (
        ('sub', 'speed_limit', 'nav2_msgs/SpeedLimit'), ('pub', 'bond', 'bond/Status'),
    ):  # fmt: skip
        assert f'| {direction} | `{topic}` | {kind} | reliable | volatile |' in rows
    (end,) = graph.node.get_subscriptions_info_by_topic('/robot/speed_limit')
    assert end.topic_type == 'nav2_msgs/msg/SpeedLimit'
    (end,) = graph.node.get_publishers_info_by_topic('/robot/bond')
    assert end.topic_type == 'bond/msg/Status'
    for code in Code:
        assert code.name in rows


def test_who_would_clear_a_local_costmap_gets_an_answer(stack):
    from nav2_msgs.srv import ClearEntireCostmap

    service, request = 'local_costmap/clear_entirely_local_costmap', ClearEntireCostmap.Request()
    assert stack.graph.call(ClearEntireCostmap, f'robot/{service}', request)


def test_a_node_that_starts_itself_has_no_bond_and_tells_of_another_server(stack, tmp_path):
    graph = stack.graph
    health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
    start(graph, tmp_path, '-r', '__ns:=/robot')

    def told():
        mine = [one for one in health if one.status[0].name == 'policy_node']
        other = 'follow_path is offered by others too: /robot/controller_server'
        return mine and other in mine[-1].status[0].message

    graph.wait(told, 'word of the other server')
    ends = graph.node.get_publishers_info_by_topic('/robot/bond')
    assert [one.node_name for one in ends] == ['controller_server']
