"""Laws of the policy node, over the middleware."""

import math
import signal

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from helpers.driving import Drive, drives_among_any_number
from helpers.faults import FAULTS
from helpers.graph import DEADLINE
from helpers.managed import change_parameter
from helpers.plans import plan_of
from helpers.robot import Robot, speed
from helpers.worlds import random_state
from nav_msgs.msg import OccupancyGrid, Odometry, Path
import numpy as np
import pytest
from std_msgs.msg import Bool
from std_srvs.srv import SetBool

from socialnav import qos
from socialnav.control.reasons import STALLED
from socialnav.messages.occupancy import map_message
from socialnav.messages.stamps import nanoseconds_of
from socialnav.parameters import DEFAULT_MODEL


@pytest.fixture
def driving(graph):
    """Return commands and the two processes of a robot that drives."""
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    simulator = graph.start('simulator_node')
    policy = graph.start('policy_node', model='orca', bounds=7.5)
    graph.wait(lambda: commands and speed(commands[-1]) > 0.1, 'motion')
    return commands, simulator, policy


def test_in_real_time_the_policy_brings_the_robot_nearer_to_its_goal(graph, driving):
    odometry, goals = graph.listen(Odometry, 'odom'), graph.listen(PoseStamped, 'goal_pose')
    graph.wait(lambda: odometry and goals, 'inputs')

    def distance(one):
        place, goal = one.pose.pose.position, goals[0].pose.position
        return math.hypot(place.x - goal.x, place.y - goal.y)

    start = distance(odometry[0])
    graph.wait(lambda: distance(odometry[-1]) < start - 1.0, 'progress')


@pytest.mark.parametrize('number', [signal.SIGTERM, signal.SIGINT])
def test_a_signal_ends_the_policy_with_a_zero_command_as_the_last(graph, driving, number):
    commands, _, policy = driving
    graph.kill(policy, number)
    graph.wait(lambda: policy.poll() is not None, 'end of the process')
    graph.spin(0.3)
    assert policy.returncode == 0, FAULTS['signal'].does
    assert speed(commands[-1]) == 0.0 and commands[-1].angular.z == 0.0


def test_without_inputs_the_robot_is_told_to_stand(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca')
    graph.wait(lambda: len(commands) >= 3, 'commands')
    assert not any(map(speed, commands))


def test_bad_inputs_stop_the_robot_and_good_ones_let_it_go_on(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca')
    robot = Robot(graph)
    robot.wait()
    good, bad = random_state(0), random_state(0)
    bad.agents.position[0, 0, 0] = math.nan
    for state, frame, moves in (
        (good, 'odom', True), (bad, 'odom', False), (good, 'odom', True), (good, 'camera', False),
    ):  # fmt: skip

        def publish(state=state, frame=frame, moves=moves):
            robot.publish(state, frame=frame)
            graph.spin(0.05)
            return commands and (speed(commands[-1]) > 0.0) == moves

        graph.wait(publish, f'reaction to {frame}')


@pytest.mark.parametrize('model', ['gat4sn', DEFAULT_MODEL])
def test_a_policy_that_looks_ahead_drives_among_any_number_of_agents_too(graph, model):
    drives_among_any_number(Drive(graph).start(model=model))


def test_a_stamped_command_can_be_had_instead(graph):
    commands = graph.listen(TwistStamped, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca', enable_stamped_cmd_vel=True)
    graph.wait(lambda: commands, 'commands')
    assert commands[0].header.frame_id == 'base_link' and commands[0].header.stamp.sec > 0


def test_the_end_of_a_run_is_announced_and_the_robot_stands(graph):
    arrivals = graph.listen(Bool, 'policy_node/goal_reached', qos.GOAL_REACHED)
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca')
    robot = Robot(graph)
    robot.wait()
    state = random_state(0)
    state.robot.goal[:] = state.robot.position + 0.1

    def publish():
        robot.publish(state)
        graph.spin(0.05)
        return arrivals and arrivals[-1].data

    graph.wait(publish, 'arrival')
    assert speed(commands[-1]) == 0.0


def test_while_the_clock_stands_the_robot_is_told_to_stand(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca', use_sim_time=True)
    graph.wait(lambda: len(commands) >= 2, 'commands of the watchdog')
    assert not any(map(speed, commands))


def test_limits_can_be_changed_live_and_frames_cannot(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('policy_node', model='orca')
    graph.wait(lambda: commands, 'commands')

    assert change_parameter(graph, 'max_speed', type=3, double_value=0.4).successful
    assert not change_parameter(graph, 'max_speed', type=3, double_value=-1.0).successful
    refusal = change_parameter(graph, 'planning_frame', type=4, string_value='map')
    assert not refusal.successful and 'deactivate it first' in refusal.reason


def test_a_speed_limit_that_is_changed_live_is_kept(graph, driving):
    commands, _, _ = driving
    assert change_parameter(graph, 'max_speed', type=3, double_value=0.25).successful
    commands.clear()
    graph.wait(lambda: len(commands) >= 10, 'commands')
    assert 0.2 < max(map(speed, commands)) < 0.2500001


@pytest.mark.parametrize(
    ('name', 'parameters', 'text'),
    [
        ('policy_node', {'controller_frequency': -1.0}, 'controller_frequency must be'),
        ('policy_node', {'max_sped': 0.3}, 'did you mean max_speed'),
        ('policy_node', {'threads': 'many'}, 'threads must be a whole number'),
        ('simulator_node', {'scenario': 'hart'}, 'did you mean hard'),
        ('simulator_node', {'kinematics': 'legs'}, 'kinematics must be one of'),
    ],
)
def test_a_wrong_parameter_is_one_line_and_exit_code_1(graph, name, parameters, text):
    process = graph.start(name, **parameters)
    _, errors = process.communicate(timeout=DEADLINE)
    assert process.returncode == 1
    assert text in errors and errors.startswith(name) and errors.count('\n') == 1


def test_the_robot_leaves_the_straight_way_to_follow_a_plan_and_says_so(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
    plans = graph.node.create_publisher(Path, 'plan', qos.PLAN)
    graph.start('policy_node', model='straight_line')
    robot, state = Robot(graph), random_state(0, pedestrians=0, obstacles=0)
    robot.wait()
    graph.wait(plans.get_subscription_count, 'subscriber of the plan')
    state.robot.heading[:], state.robot.velocity[:] = 0.0, 0.0
    state.robot.goal[:] = state.robot.position + [[5.0, 0.0]]
    start, goal = state.robot.position[0], state.robot.goal[0]
    detour, elsewhere = [start, start + (0.0, 4.0), goal], [start, goal + (0.0, 4.0)]
    for corners, note, direction in (
        (detour, 'followed', (0.0, 1.0)),
        (elsewhere, 'ignored: plan: it ends 4.00 m from the goal', (1.0, 0.0)),
    ):
        plans.publish(plan_of(corners, stamp=0))

        def as_wanted(note=note, direction=direction):
            robot.publish(state)
            graph.spin(0.05)
            facts = {one.key: one.value for one in health[-1].status[0].values} if health else {}
            linear = commands[-1].linear if commands else Twist().linear
            straight = math.hypot(linear.x - direction[0], linear.y - direction[1]) < 0.1
            return straight and facts.get('plan') == note

        graph.wait(as_wanted, f'plan {note}')


def test_what_the_map_shows_is_no_longer_driven_into(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
    maps = graph.node.create_publisher(OccupancyGrid, 'map', qos.MAP)
    graph.start('policy_node', model='orca', use_map=True, require_obstacles=False)
    robot, state = Robot(graph), random_state(0, pedestrians=0, obstacles=1)
    robot.wait()
    graph.node.destroy_publisher(robot.publishers.pop('obstacles'))  # of whom nothing is heard
    state.robot.heading[:], state.robot.velocity[:] = 0.0, 0.0
    state.robot.goal[:] = state.robot.position + [[5.0, 0.0]]
    state.agents.position[:], state.agents.radius[:] = state.robot.position + [[0.9, 0.0]], 0.5

    def told(message, speeds):
        robot.publish(state, without=['obstacles'])
        graph.spin(0.05)
        reason = health[-1].status[0].message if health else ''
        return commands and reason == message and speeds(commands[-1].linear.x)

    graph.wait(lambda: told('no map', lambda speed: speed == 0.0), 'stop without a map')
    free = state.with_agents(position=state.agents.position + 50.0)
    maps.publish(map_message(free, 0, 'odom'))
    graph.wait(lambda: told('driving', lambda speed: speed > 0.9), 'motion where nothing is')
    maps.publish(map_message(state, 0, 'odom'))
    graph.wait(lambda: told('driving', lambda speed: speed < 0.3), 'care before an obstacle')


def test_on_the_clock_of_a_fast_simulator_the_robot_drives_and_stands_when_it_is_paused(graph):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    odometry = graph.listen(Odometry, 'odom')
    health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
    graph.start('simulator_node', publish_clock=True, real_time_factor=3.0)
    graph.start('policy_node', model='orca', bounds=7.5, use_sim_time=True)
    graph.wait(lambda: commands and speed(commands[-1]) > 0.1, 'motion')
    stamps = [nanoseconds_of(one.header.stamp) for one in odometry]
    assert np.median(np.diff(stamps)) == 150_000_000  # at 20 Hz; less where an episode ends
    assert graph.call(SetBool, 'simulator_node/pause', SetBool.Request(data=True)).success
    graph.wait(lambda: health[-1].status[0].message == STALLED, 'word of the clock')
    graph.wait(lambda: speed(commands[-1]) == 0.0, 'stop')
    graph.call(SetBool, 'simulator_node/pause', SetBool.Request(data=False))
    commands.clear()
    graph.wait(lambda: commands and speed(commands[-1]) > 0.1, 'motion after the pause')
