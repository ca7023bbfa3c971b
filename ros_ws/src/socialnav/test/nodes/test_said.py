"""What keeps a robot from its goal is said: in diagnostics, on a topic, and in the log."""

import signal

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from helpers.driving import Drive
from helpers.faults import FAULTS
from helpers.managed import change_parameters, change_state
from helpers.plans import plan_of
from helpers.robot import KINDS, Robot, speed
from helpers.worlds import random_state
from nav_msgs.msg import Path
import pytest
from std_msgs.msg import String

from socialnav import qos
from socialnav.control.progress import ASTRAY, HELD, STANDS
from socialnav.demo.children import command_line

QUICK = {'progress_timeout': 1.0, 'progress_stop_timeout': 2.0}
MISSING = {
    'obstacles missing': 'obstacles',
    'odom missing': 'odom',
    'pedestrians missing': 'pedestrians',
    'goal missing': 'goal_pose',
}
"""Inputs by their faults; obstacles come first, since a publisher of them tells them again."""


def change(drive, **values):
    """Change parameters of the policy node."""
    assert all(one.successful for one in change_parameters(drive.graph, values.items()))


def restart(drive):
    """Let the node forget its inputs and begin anew."""
    for transition in ('deactivate', 'cleanup', 'configure', 'activate'):
        assert change_state(drive.graph, transition)


def log_of(drive, process):
    """End the node and return what it wrote."""
    drive.graph.kill(process, signal.SIGTERM)
    return process.communicate()[1]


def test_each_input_that_never_comes_is_named_and_so_is_one_of_another_type(graph):
    drive, state = Drive(graph).start(), random_state(0)
    for name, topic in MISSING.items():
        restart(drive)
        drive.until(False, FAULTS[name].said, state, name, without=[topic])
        if topic == 'obstacles':
            graph.node.destroy_publisher(drive.robot.publishers.pop(topic))
            change(drive, require_obstacles=False)
            drive.moves(state, without=[topic])
            change(drive, require_obstacles=True)
            kind, profile = KINDS[topic]
            drive.robot.publishers[topic] = graph.node.create_publisher(kind, topic, profile)
    restart(drive)
    graph.node.destroy_publisher(drive.robot.publishers.pop('odom'))
    drive.until(False, FAULTS['nobody publishes'].said, state, 'nobody', without=['odom'])
    graph.node.create_publisher(PoseStamped, 'odom', qos.ODOMETRY)
    drive.until(False, FAULTS['odom of another type'].said, state, 'type', without=['odom'])


def test_a_robot_without_progress_says_so_stops_and_goes_on_with_another_goal(graph):
    drive = Drive(graph)
    process = graph.start('policy_node', model='orca', **QUICK)
    drive.robot.wait()
    states = graph.listen(String, 'policy_node/state', qos.STATE)
    state = random_state(0)
    drive.moves(state)
    drive.says('held', state)
    assert speed(drive.commands[-1]) > 0.1 and HELD in states[-1].data
    drive.until(False, FAULTS['held for long'].said, state, 'held')
    assert states[-1].data.startswith('standing: no progress')
    state.robot.goal[:] += 1.0
    drive.moves(state, 'another goal')

    def away():
        state.robot.position[:] += (state.robot.position - state.robot.goal) * 0.01
        drive.robot.publish(state)
        graph.spin(0.05)
        return FAULTS['astray'].said in states[-1].data

    graph.wait(away, ASTRAY)
    graph.wait(lambda: away() and states[-1].data.startswith('standing'), 'stop')
    log = log_of(drive, process)
    assert HELD in log and ASTRAY in log


def test_a_policy_that_chooses_to_stand_makes_no_progress_and_drives_on_when_it_wants(graph):
    drive, state = Drive(graph).start(**QUICK), random_state(0)
    drive.moves(state)
    change(drive, max_speed=0.0)
    drive.says('no way', state)
    assert FAULTS['no way'].said == STANDS
    drive.until(False, FAULTS['held for long'].said, state, 'stands')
    for _ in range(120):
        drive.robot.publish(state)
        graph.spin(0.05)
    change(drive, max_speed=1.0)
    drive.moves(state, 'the way is free')


@pytest.mark.parametrize('stamped', [False, True])
def test_a_base_that_wants_the_other_type_or_does_not_listen_is_named(graph, stamped):
    robot, state = Robot(graph), random_state(0)
    health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
    graph.listen(Twist if stamped else TwistStamped, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca', enable_stamped_cmd_vel=stamped)
    robot.wait()
    advice = FAULTS['base of another type'].said.replace('true', str(not stamped).lower())

    def told():
        robot.publish(state)
        graph.spin(0.05)
        message = health[-1].status[0].message if health else ''
        return message.startswith('driving; /probe wants') and advice in message

    graph.wait(told, advice)


def test_commands_that_nobody_hears_and_odometry_without_a_frame_are_named(graph):
    drive, state = Drive(graph), random_state(0)
    graph.start('policy_node', model='orca')
    drive.robot.wait()
    for subscription in list(graph.node.subscriptions):
        if subscription.topic_name == '/cmd_vel':
            graph.node.destroy_subscription(subscription)
    drive.says('nobody listens', state)

    def unnamed(messages):
        messages['odom'].child_frame_id = ''

    drive.says('twist nowhere', state, change=unnamed)


def test_a_plan_that_cannot_be_used_and_one_that_is_very_long_do_not_stop_the_robot(graph):
    drive, state = Drive(graph).start(), random_state(0)
    plans = graph.node.create_publisher(Path, 'plan', qos.PLAN)
    graph.wait(plans.get_subscription_count, 'node')
    drive.moves(state)
    start, goal = (tuple(one[0].tolist()) for one in (state.robot.position, state.robot.goal))
    for points, note in (
        ([start], FAULTS['plan unusable'].said),
        ([start, *[goal] * 99_999], 'followed'),
    ):
        plans.publish(plan_of(points))
        drive.moves(state)

        def noted(note=note):
            drive.robot.publish(state)
            graph.spin(0.05)
            facts = {one.key: one.value for one in drive.health[-1].status[0].values}
            return note in facts['plan']

        graph.wait(noted, note)
    drive.commands.clear()
    for _ in range(40):
        drive.robot.publish(state)
        graph.spin(0.05)
    told = drive.health[-1].status[0].message
    assert len(drive.commands) >= 15 and all(map(speed, drive.commands)), told
    assert FAULTS['plan long'].said in told


def test_the_log_ends_with_what_is_true_however_soon_the_reason_changed(graph):
    drive, state = Drive(graph), random_state(0)
    process = graph.start('policy_node', model='orca')
    drive.robot.wait()
    drive.until(False, 'no goal_pose', state, 'no goal', without=['goal_pose'])
    drive.shows('stamps of the past', state, shift=-5.0)
    for _ in range(40):
        drive.robot.publish(state, shift=-5.0)
        graph.spin(0.05)
    standing = [one for one in log_of(drive, process).splitlines() if 'standing: ' in one]
    assert FAULTS['stamps of the past'].said in standing[-1]


def test_what_the_robot_drives_without_is_said_at_the_start(graph):
    process = graph.start('policy_node', model='orca', require_obstacles=False)
    graph.wait(lambda: graph.node.count_publishers('cmd_vel'), 'node')
    graph.spin(1.0)
    graph.kill(process, signal.SIGTERM)
    assert FAULTS['nothing stands'].said in process.communicate()[1]


def test_a_log_that_tells_everything_tells_of_standing_and_of_driving(graph):
    drive, state = Drive(graph), random_state(0)
    command = command_line('policy_node', {'model': 'straight_line'})
    process = graph.run([*command, '--log-level', 'info'])  # the level of a node as it is
    drive.robot.wait()
    drive.until(False, 'no goal_pose', state, 'no goal', without=['goal_pose'])
    drive.moves(state)
    for _ in range(30):  # longer than the pause between two lines
        drive.robot.publish(state)
        graph.spin(0.05)
    drive.until(False, 'from the future', state, 'the clock', shift=5.0)
    lines = log_of(drive, process)
    assert 'standing: no goal_pose' in lines and ': driving' in lines
