"""What several nodes tell of one robot counts together, over the middleware."""

import time

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist
from helpers.robot import speed
from helpers.sensing import Measuring, resting_state, start_obstacle_node
from helpers.worlds import messages_of

from socialnav import qos
from socialnav_msgs.msg import AgentStates

AHEAD = [(1.2, 0.0)], [0.5]
NOTHING = [], []
FRONT_AND_REAR = {'front': AHEAD, 'rear': NOTHING}
SENSORS = {'require_obstacles': True, 'obstacles_timeout': 0.5}


class Drive:
    """A policy node, its commands and what it says."""

    def __init__(self, graph, **parameters):
        self.graph = graph
        self.commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
        self.health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
        self.process = graph.start('policy_node', model='orca', **parameters)

    def reason(self):
        """Return what the policy node says."""
        told = [one.status[0] for one in self.health if one.status[0].name == 'policy_node']
        return told[-1].message if told else ''

    def ahead(self):
        """Return whether the robot is going straight ahead as fast as it likes."""
        return bool(self.commands) and self.commands[-1].linear.x > 0.9


def test_what_one_of_two_lasers_sees_is_not_driven_into(graph):
    drive, robot = Drive(graph, **SENSORS), Measuring(graph, 'front', 'rear')
    start_obstacle_node(graph, 'rear')
    robot.until(drive.ahead, 'motion of a robot that sees nothing', rear=NOTHING)
    start_obstacle_node(graph, 'front')  # of the same name, as whoever starts it twice has it
    robot.until(lambda: not drive.ahead(), 'reaction', **FRONT_AND_REAR)
    robot.during(0.5, **FRONT_AND_REAR)
    drive.commands.clear()
    robot.during(2.0, **FRONT_AND_REAR)
    assert len(drive.commands) > 10
    assert all(one.linear.x < 0.9 for one in drive.commands)


def test_when_one_of_two_lasers_falls_silent_the_robot_stands_and_says_which(graph):
    drive, robot = Drive(graph, **SENSORS), Measuring(graph, 'front', 'rear')
    start_obstacle_node(graph, 'rear')
    graph.run(
        ['ros2', 'run', 'socialnav', 'obstacle_node', '--ros-args', '-r', 'scan:=front']
        + ['-r', '__node:=front_obstacles']
    )
    both = {'front': NOTHING, 'rear': NOTHING}
    robot.until(drive.ahead, 'motion', **both)
    robot.until(
        lambda: drive.reason() == 'obstacles older than 0.5 s, told by /front_obstacles',
        'reason', rear=NOTHING,
    )  # fmt: skip
    drive.commands.clear()
    robot.during(0.5, rear=NOTHING)
    assert not any(map(speed, drive.commands))
    robot.until(drive.ahead, 'motion', **both)


def test_an_obstacle_node_that_was_killed_and_started_anew_leaves_no_ghost(graph):
    drive, robot = Drive(graph, **SENSORS), Measuring(graph, 'front')
    process = start_obstacle_node(graph, 'front')
    robot.until(lambda: drive.reason() == 'driving', 'decision', front=AHEAD)
    assert not drive.ahead()
    graph.kill(process)
    start_obstacle_node(graph, 'front')
    lists = graph.listen(AgentStates, 'obstacles', qos.OBSTACLES_INPUT)
    robot.until(lambda: lists and not lists[-1].agents, 'list of the new node', front=NOTHING)
    began = time.monotonic()
    robot.until(drive.ahead, 'motion', front=NOTHING)
    assert time.monotonic() - began < 1.0  # the time-out, a period and a busy machine


def test_publishers_that_cannot_be_told_apart_are_named_and_the_robot_stands(graph):
    drive, robot = Drive(graph, require_obstacles=False), Measuring(graph)
    robot.until(drive.ahead, 'motion')
    other = graph.node.create_publisher(AgentStates, 'pedestrians', qos.PEDESTRIANS)
    words = 'pedestrians: several publishers do not fill in their source: /probe'
    robot.until(lambda: drive.reason() == words, 'reason')
    drive.commands.clear()
    robot.during(0.5)
    assert not any(map(speed, drive.commands))
    graph.node.destroy_publisher(other)
    robot.until(drive.ahead, 'motion')


def test_people_of_two_trackers_are_all_avoided(graph):
    robot = Measuring(graph, people=False)
    drive = Drive(graph, require_obstacles=False)
    publishers = {
        source: graph.node.create_publisher(AgentStates, 'pedestrians', qos.PEDESTRIANS)
        for source in ('/front:1', '/rear:1')
    }

    def tell(people):
        for source, publisher in publishers.items():
            message = messages_of(robot.state, robot.now())['pedestrians']
            message.source = source
            if source == '/front:1':
                message.agents = people
            publisher.publish(message)

    robot.until(lambda: tell([]) or drive.ahead(), 'motion')
    person = one_person((1.5, 0.0))
    robot.until(lambda: tell(person) or not drive.ahead(), 'reaction')
    drive.commands.clear()
    for _ in range(40):
        tell(person)
        robot.during(0.05)
    assert len(drive.commands) > 10 and not any(one.linear.x > 0.9 for one in drive.commands)


def one_person(where):
    """Return a list of one person who stands somewhere."""
    state = resting_state(pedestrians=1)
    state.agents.position[:], state.agents.velocity[:] = where, 0.0
    return messages_of(state)['pedestrians'].agents


def test_one_node_takes_several_scans_and_tells_nothing_until_all_have_come(graph):
    robot = Measuring(graph, 'front', 'rear')
    lists = graph.listen(AgentStates, 'obstacles', qos.OBSTACLES_INPUT)
    graph.start(
        'obstacle_node', scan_topics='front rear',
        laser_frames='front_laser 0 0 0; rear_laser 0 0 3.14159265',
    )  # fmt: skip
    ready = [one.get_subscription_count for one in robot.scans.values()]
    graph.wait(lambda: all(count() for count in ready), 'node')
    robot.during(0.5, front=AHEAD)
    assert lists == []
    robot.until(lambda: lists, 'obstacles', front=AHEAD, rear=AHEAD)
    places = sorted((round(one.position.x, 1), one.radius) for one in lists[-1].agents)
    assert [place for place, _ in places] == [-1.2, 1.2]
    robot.during(1.0, front=AHEAD)  # as of the laser that has fallen silent, so that they age
    stamps = [one.header.stamp.sec + one.header.stamp.nanosec * 1e-9 for one in lists[-5:]]
    assert max(stamps) - min(stamps) == 0.0
