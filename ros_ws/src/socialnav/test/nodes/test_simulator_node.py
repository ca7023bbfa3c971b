"""Laws of the simulator node, over the middleware."""

import signal

from geometry_msgs.msg import PoseArray, PoseStamped, Twist, TwistStamped
from helpers.faults import FAULTS
from helpers.robot import speed
from nav_msgs.msg import OccupancyGrid, Odometry
import numpy as np
import pytest
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from std_srvs.srv import SetBool
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav.messages.stamps import nanoseconds_of, time_message
from socialnav_core.sensing import DetectorSettings, ScannerSettings, Sensors
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_msgs.msg import AgentStates, EpisodeResult
from socialnav_msgs.srv import StartEpisode

TOPICS = {
    '/pedestrians': 'socialnav_msgs/msg/AgentStates',
    '/obstacles': 'socialnav_msgs/msg/AgentStates',
    '/odom': 'nav_msgs/msg/Odometry',
    '/goal_pose': 'geometry_msgs/msg/PoseStamped',
    '/map': 'nav_msgs/msg/OccupancyGrid',
    '/markers': 'visualization_msgs/msg/MarkerArray',
    '/episode_result': 'socialnav_msgs/msg/EpisodeResult',
    '/clock': 'rosgraph_msgs/msg/Clock',
    '/cmd_vel': 'geometry_msgs/msg/Twist',
}


def answer(publisher, odometry, x=0.0, y=0.0, offset=0):
    """Send a command that answers the state of an odometry message."""
    command = TwistStamped()
    command.header.stamp = time_message(nanoseconds_of(odometry.header.stamp) + offset)
    command.twist.linear.x, command.twist.linear.y = x, y
    publisher.publish(command)


def place(odometry):
    """Return the position of the robot."""
    return odometry.pose.pose.position.x, odometry.pose.pose.position.y


def lockstep(graph, **parameters):
    """Start a simulator in lockstep; return its odometry and a publisher of commands."""
    odometry = graph.listen(Odometry, 'odom')
    publisher = graph.node.create_publisher(TwistStamped, 'cmd_vel', qos.COMMAND)
    graph.start('simulator_node', lockstep=True, **parameters)
    graph.wait(lambda: odometry and publisher.get_subscription_count(), 'state')
    return odometry, publisher


def test_all_topics_appear_with_their_types(graph):
    graph.start('simulator_node', publish_clock=True)
    graph.wait(
        lambda: TOPICS.keys() <= dict(graph.node.get_topic_names_and_types()).keys(), 'topics'
    )
    found = dict(graph.node.get_topic_names_and_types())
    assert {name: found[name] for name in TOPICS} == {
        name: [kind] for name, kind in TOPICS.items()
    }


def test_the_published_world_is_the_simulated_one(graph):
    pedestrians = graph.listen(AgentStates, 'pedestrians')
    obstacles = graph.listen(AgentStates, 'obstacles', qos.OBSTACLES)
    goals = graph.listen(PoseStamped, 'goal_pose')
    odometry, _ = lockstep(graph, scenario='hard', seed=4)
    graph.wait(lambda: pedestrians and obstacles and goals, 'complete state')
    state = Simulator(make_scenario('hard'), batch_size=1).reset(seed=4, cases=[0])
    seen = [*pedestrians[0].agents, *obstacles[0].agents]
    positions = [(agent.position.x, agent.position.y) for agent in seen]
    np.testing.assert_array_equal(positions, state.agents.position[0])
    np.testing.assert_array_equal([agent.radius for agent in seen], state.agents.radius[0])
    assert [agent.id for agent in seen] == list(range(10))
    goal = goals[0].pose.position
    assert place(odometry[0]) == tuple(state.robot.position[0])
    assert (goal.x, goal.y) == tuple(state.robot.goal[0])


def advance(graph, odometry, publisher, **command):
    """Answer the present state, as often as it comes, until the next one is there."""
    stamp = odometry[-1].header.stamp
    answered = 0

    def moved_on():
        nonlocal answered
        if odometry[-1].header.stamp != stamp:
            return True
        if len(odometry) > answered:
            answered = len(odometry)
            answer(publisher, odometry[-1], **command)
        return False

    graph.wait(moved_on, 'next state')


def test_in_lockstep_a_command_advances_the_world_by_one_step(graph):
    odometry, publisher = lockstep(graph)
    first = odometry[-1]
    advance(graph, odometry, publisher, x=1.0)
    elapsed = nanoseconds_of(odometry[-1].header.stamp) - nanoseconds_of(first.header.stamp)
    assert elapsed == 250_000_000
    assert np.hypot(*np.subtract(place(odometry[-1]), place(first))) == pytest.approx(0.25)


def test_in_lockstep_a_command_with_another_stamp_is_ignored(graph):
    odometry, publisher = lockstep(graph)
    advance(graph, odometry, publisher)
    present = odometry[-1]
    answer(publisher, present, x=1.0, offset=1)
    graph.spin(0.4)
    assert odometry[-1].header.stamp == present.header.stamp
    assert place(odometry[-1]) == place(present)


def test_in_lockstep_a_state_comes_again_while_there_is_no_answer(graph):
    odometry, _ = lockstep(graph)
    first = nanoseconds_of(odometry[0].header.stamp)
    graph.wait(lambda: len(odometry) >= 3, 'repetitions', deadline=3.0)
    assert {nanoseconds_of(one.header.stamp) for one in odometry} == {first}


def test_episodes_end_with_a_result_and_the_world_stands_after_the_last(graph):
    results = graph.listen(EpisodeResult, 'episode_result', qos.EPISODE_RESULT)
    odometry, publisher = lockstep(graph, episodes=1, seed=3)
    while not results:
        advance(graph, odometry, publisher, x=1.0)
        graph.spin(0.01)
    result = results[0]
    assert (result.scenario, result.seed, result.case_index) == ('hard', 3, 0)
    assert result.outcome in ('collision', 'out_of_bounds', 'goal')
    assert result.steps == round(result.time / 0.25)
    graph.spin(0.2)
    count = len(odometry)
    graph.spin(1.0)
    assert len(odometry) == count


def test_a_case_can_be_started_by_name_and_a_wrong_one_is_refused(graph):
    odometry, _ = lockstep(graph)
    before = place(odometry[-1])
    request = StartEpisode.Request(scenario='simple', seed=9, case_index=5)
    assert graph.call(StartEpisode, 'simulator_node/start_episode', request).success
    start = Simulator(make_scenario('simple'), batch_size=1).reset(seed=9, cases=[5])
    graph.wait(lambda: place(odometry[-1]) != before, 'other case')
    assert place(odometry[-1]) == tuple(start.robot.position[0])
    request.scenario = 'nowhere'
    refusal = graph.call(StartEpisode, 'simulator_node/start_episode', request)
    assert not refusal.success and 'nowhere' in refusal.message


def test_in_real_time_the_robot_follows_commands_and_brakes_without_them(graph):
    odometry = graph.listen(Odometry, 'odom')
    publisher = graph.node.create_publisher(Twist, 'cmd_vel', qos.COMMAND)
    graph.start('simulator_node')
    graph.wait(publisher.get_subscription_count, 'subscriber')
    publisher.publish(Twist())
    command = Twist()
    command.linear.x = 0.2
    publisher.publish(command)
    graph.wait(lambda: odometry and odometry[-1].twist.twist.linear.x > 0.19, 'motion')
    graph.wait(lambda: odometry[-1].twist.twist.linear.x == 0.0, 'brake', deadline=1.5)


def test_a_command_that_is_no_number_is_ignored(graph):
    odometry = graph.listen(Odometry, 'odom')
    publisher = graph.node.create_publisher(Twist, 'cmd_vel', qos.COMMAND)
    process = graph.start('simulator_node')
    graph.wait(publisher.get_subscription_count, 'subscriber')
    command = Twist()
    command.linear.x = float('nan')
    publisher.publish(command)
    count = len(odometry)
    graph.wait(lambda: len(odometry) > count + 10, 'states')
    assert process.poll() is None and odometry[-1].twist.twist.linear.x == 0.0


def test_in_real_time_states_come_at_the_rate_that_is_asked_for(graph):
    odometry = graph.listen(Odometry, 'odom')
    graph.start('simulator_node', publish_rate=50.0, publish_clock=True)
    graph.wait(lambda: len(odometry) > 60, 'states')
    stamps = [nanoseconds_of(one.header.stamp) for one in odometry[10:60]]
    assert set(np.diff(stamps)) == {20_000_000}


def test_the_clock_stops_while_the_world_is_paused(graph):
    clocks = graph.listen(Clock, '/clock', qos.CLOCK)
    graph.start('simulator_node', publish_clock=True)
    graph.wait(lambda: clocks, 'clock')
    assert graph.call(SetBool, 'simulator_node/pause', SetBool.Request(data=True)).success
    graph.spin(0.2)
    count = len(clocks)
    graph.spin(0.5)
    assert len(clocks) == count
    graph.call(SetBool, 'simulator_node/pause', SetBool.Request(data=False))
    graph.wait(lambda: len(clocks) > count, 'clock')


def test_a_late_subscriber_is_told_the_goal_with_its_first_stamp(graph):
    early = graph.listen(PoseStamped, 'goal_pose')
    graph.start('simulator_node')
    graph.wait(lambda: early, 'goal')
    late = graph.listen(PoseStamped, 'goal_pose')
    graph.wait(lambda: late, 'goal for the late one')
    assert late[0] == early[0]


def test_a_goal_set_by_hand_becomes_the_goal_of_the_episode(graph):
    goals = graph.listen(PoseStamped, 'goal_pose')
    publisher = graph.node.create_publisher(PoseStamped, 'goal_pose', qos.GOAL)
    graph.start('simulator_node')
    graph.wait(lambda: goals and publisher.get_subscription_count() == 2, 'goal')
    wanted = PoseStamped()
    wanted.header.frame_id = 'map'
    wanted.pose.position.x, wanted.pose.position.y = 1.25, -0.5
    publisher.publish(wanted)

    def taken(goal):
        place = goal.pose.position
        return goal.header.frame_id == 'odom' and (place.x, place.y) == (1.25, -0.5)

    graph.wait(lambda: any(map(taken, goals)), 'goal of the simulator')


def test_the_map_shows_obstacles_and_walls(graph):
    maps = graph.listen(OccupancyGrid, 'map', qos.MAP)
    obstacles = graph.listen(AgentStates, 'obstacles', qos.OBSTACLES)
    graph.start('simulator_node')
    graph.wait(lambda: maps and obstacles, 'map')
    info = maps[0].info
    cells = np.array(maps[0].data).reshape(info.height, info.width)

    def level(x, y):
        column = int((x - info.origin.position.x) / info.resolution)
        return cells[int((y - info.origin.position.y) / info.resolution), column]

    assert level(7.6, 0.0) == 100 and level(7.4, 7.4) == 0
    for obstacle in obstacles[0].agents:
        assert level(obstacle.position.x, obstacle.position.y) == 100


def test_markers_show_everybody(graph):
    arrays = graph.listen(MarkerArray, 'markers', qos.MARKERS)
    graph.start('simulator_node')
    markers = graph.wait(lambda: arrays and arrays[0].markers, 'markers')
    names = [marker.ns for marker in markers if marker.action == marker.ADD]
    assert names.count('pedestrians') == 5 and names.count('obstacles') == 5
    assert names.count('robot') == 1 and names.count('goal') == 1


def test_a_scan_and_detections_are_of_the_state_with_their_stamp(graph):
    scans = graph.listen(LaserScan, 'scan', qos.SCAN)
    detections = graph.listen(PoseArray, 'detections')
    lockstep(graph, seed=4, publish_scan=True, publish_detections=True, scan_beams=90)
    graph.wait(lambda: scans and detections, 'measurements')
    state = Simulator(make_scenario('hard'), batch_size=1).reset(seed=4, cases=[0])
    ranges = Sensors(ScannerSettings(90), DetectorSettings(), 4, 0).scan(state)
    np.testing.assert_allclose(scans[0].ranges, ranges, rtol=1e-6)
    seen = sorted((pose.position.x, pose.position.y) for pose in detections[0].poses)
    assert seen == sorted(map(tuple, state.agents.position[0][~state.agents.static[0]]))
    assert scans[0].header.stamp == detections[0].header.stamp


def test_noise_of_sensors_does_not_change_the_world(graph):
    odometry, publisher = lockstep(graph, seed=4, publish_scan=True, scan_noise=0.1)
    advance(graph, odometry, publisher, x=1.0)
    simulator = Simulator(make_scenario('hard'), batch_size=1)
    simulator.reset(seed=4, cases=[0])
    state = simulator.step(np.array([[1.0, 0.0]]))[0]
    np.testing.assert_allclose(place(odometry[-1]), state.robot.position[0], atol=1e-9)


@pytest.mark.parametrize('wanted', [1e300, 7.0, -5.0])
def test_the_base_drives_no_faster_than_it_can_and_not_at_all_where_that_is_no_speed(
    graph, wanted
):
    odometry = graph.listen(Odometry, 'odom')
    publisher = graph.node.create_publisher(Twist, 'cmd_vel', qos.COMMAND)
    simulator = graph.start('simulator_node', max_speed=0.8)
    graph.wait(lambda: odometry and publisher.get_subscription_count(), 'state')

    def drives():
        command = Twist()
        command.linear.x, command.linear.y = wanted, 0.5 * wanted
        publisher.publish(command)
        graph.spin(0.05)
        return speed(odometry[-1].twist.twist) > 0.1

    if wanted > 1e9:
        for _ in range(10):
            assert not drives()
    else:
        graph.wait(drives, 'motion')
        assert speed(odometry[-1].twist.twist) == pytest.approx(0.8)
        velocity = odometry[-1].twist.twist.linear
        assert velocity.y / velocity.x == pytest.approx(0.5)
    graph.kill(simulator, signal.SIGTERM)
    assert FAULTS['no speed' if wanted > 1e9 else 'too fast'].said in simulator.communicate()[1]
