"""Laws of the action follow_path, with the real node and a real client: how each path ends."""

import math
import time

from geometry_msgs.msg import PoseStamped
from helpers import stops
from helpers.faults import FAULTS
from helpers.graph import open_graph
from helpers.managed import change_parameters, change_state
from helpers.nav2_interfaces import nav2_interfaces
from helpers.path_client import Base, line, path_of, PathClient
from helpers.robot import speed
import numpy as np
import pytest
from std_srvs.srv import Trigger

from socialnav.demo.children import command_line
from socialnav.messages.stamps import header_message

SUCCEEDED, CANCELED, ABORTED = 4, 5, 6
PARAMETERS = {
    'model': 'straight_line', 'preferred_speed': 2.0, 'max_speed': 2.0, 'goal_tolerance': 0.25,
    'goal_yaw_tolerance': 0.2, 'progress_timeout': 1.5, 'failure_tolerance': 0.3,
}  # fmt: skip
SILENCE = 0.2
"""Time in which no command comes from a node that lets others command the robot, s."""


class World:
    """A policy node, a base and a client."""

    def __init__(self, graph, log):
        self.graph, self.base, self.client = graph, Base(graph), PathClient(graph)
        self.log = log
        graph.run(command_line('policy_node', PARAMETERS), log=log)
        self.client.wait()
        self.base.robot.wait()

    def ahead(self, length, **options):
        """Have a path followed that begins at the robot and goes east, then back the next time."""
        start = self.base.state.robot.position[0].copy()
        way = length if start[0] < 0 else -length
        return self.client.send(line(start, start + [way, 0.0]), **options)

    def moves(self):
        """Wait until the robot is told to move."""
        self.graph.wait(lambda: speed(self.base.command) > 0.5, 'motion')

    def is_left_alone(self):
        """Return whether the robot stands, and nobody commands it or waits for anything."""
        self.graph.wait(self.base.stands, 'stop')
        self.graph.wait(lambda: not self.client.active(), 'end of all paths')
        self.graph.spin(SILENCE)  # the last command may come after the outcome
        count = len(self.base.commands)
        self.graph.spin(SILENCE)
        return len(self.base.commands) == count


@pytest.fixture(scope='module')
def world(tmp_path_factory):
    """Yield a world that all tests of this file use in turn."""
    with nav2_interfaces(), open_graph() as graph:
        yield World(graph, tmp_path_factory.mktemp('log') / 'policy_node')


def succeeds(world):
    """Drive along a path and turn to its heading."""
    yaw = world.base.state.robot.heading[0] + 0.7
    known = world.ahead(1.5, yaw=yaw)
    assert world.client.outcome(known) == (SUCCEEDED, 0, '')
    left = [one.distance_to_goal for one in known.feedback]
    assert left[0] == pytest.approx(1.5, abs=0.3) and left[-1] < 0.3
    assert max(one.speed for one in known.feedback) == pytest.approx(2.0, abs=0.1)
    assert abs(math.remainder(world.base.state.robot.heading[0] - yaw, math.tau)) < 0.3


def is_cancelled(world):
    """Cancel a path on the way."""
    known = world.ahead(6.0)
    world.moves()
    began = time.monotonic()
    assert world.client.cancel(known)
    world.graph.wait(world.base.stands, 'stop')
    stops.note('a path is cancelled', time.monotonic() - began, FAULTS['path cancelled'].within)
    assert world.client.outcome(known)[0] == CANCELED
    world.client.ends(known, 'path cancelled')


def is_replaced(world):
    """Send three more paths to one goal on the way, as bt_navigator does."""
    start = world.base.state.robot.position[0].copy()
    goal = start + [3.0 if start[0] < 0 else -3.0, 0.5]
    former = world.client.send(line(start, goal))
    world.moves()
    world.base.commands.clear()
    for _ in range(3):
        world.graph.spin(0.15)
        newer = world.client.send(line(world.base.state.robot.position[0], goal))
        assert world.client.outcome(former)[0] == ABORTED
        world.client.ends(former, 'path replaced')
        former = newer
    assert min(map(speed, world.base.commands)) > 1.9, 'a newer path must not brake the robot'
    assert world.client.outcome(former) == (SUCCEEDED, 0, '')


def is_empty(world):
    """Send a path without poses while another one is followed, which ends too."""
    former = world.ahead(4.0)
    world.moves()
    world.client.ends(world.client.send([]), 'path empty')
    world.client.ends(former, 'path replaced')


def is_nowhere(world):
    """Send a path through NaN."""
    world.client.ends(world.client.send([(0, 0), (math.nan, 1), (2, 2)]), 'path nan')


def is_mixed(world):
    """Send a path of which one pose is in another frame."""
    path = path_of(line((0, 0), (1, 1)))
    path.poses[3].header.frame_id = 'map'
    world.client.ends(world.client.send_path(path), 'path mixed')


def is_elsewhere(world):
    """Send a path in a frame that nobody knows."""
    world.client.ends(world.client.send(line((0, 0), (1, 1)), frame='map'), 'path elsewhere')


def has_another_controller(world):
    """Ask for a controller that is not there."""
    world.client.ends(world.ahead(1.0, controller_id='DWB'), 'controller unknown')
    for name in ('goal_checker_id', 'progress_checker_id'):
        world.client.ends(world.ahead(1.0, **{name: 'other'}), 'checker unknown')


def is_held(world):
    """Hold the robot on the way."""
    known = world.ahead(4.0)
    world.moves()
    world.base.held = True
    world.client.ends(known, 'path held')
    world.base.held = False


def has_no_odometry(world):
    """Let odometry stop on the way."""
    known = world.ahead(4.0)
    world.moves()
    world.base.without = ('goal_pose', 'odom')
    world.client.ends(known, 'path without odom')
    world.base.without = ('goal_pose',)


def with_nan(messages):
    """Put somebody to NaN."""
    from socialnav_msgs.msg import AgentState

    somebody = AgentState()
    somebody.position.x = math.nan
    messages['pedestrians'].agents = [somebody]


def loses_patience(world, name='path with nan'):
    """Let an input be NaN on the way."""
    known = world.ahead(4.0)
    world.moves()
    world.base.change = with_nan
    world.client.ends(known, name)
    world.base.change = lambda messages: None


def has_no_patience(world):
    """Let an input be NaN on the way, without tolerance."""
    change_parameters(world.graph, [('failure_tolerance', 0.0)])
    loses_patience(world, 'path with nan at once')
    change_parameters(world.graph, [('failure_tolerance', 0.3)])


def is_cancelled_by_service(world):
    """Cancel the goal of a path by the node's service."""
    known = world.ahead(4.0)
    world.moves()
    assert world.graph.call(Trigger, 'policy_node/cancel_goal', Trigger.Request()).success
    world.client.ends(known, 'goal cancelled')


ENDS = [
    succeeds, is_cancelled, is_replaced, is_empty, is_nowhere, is_mixed, is_elsewhere,
    has_another_controller, is_held, has_no_odometry, loses_patience, has_no_patience,
    is_cancelled_by_service,
]  # fmt: skip


@pytest.mark.parametrize('end', ENDS, ids=lambda end: end.__name__)
def test_a_path_ends_as_nav2_means_it_and_the_robot_stands_and_is_left_alone(world, end):
    end(world)
    assert world.is_left_alone()


@pytest.mark.slow
def test_fifty_paths_end_as_nav2_means_it_and_leave_nothing_behind(world):
    order = np.random.default_rng(0).permutation(np.arange(50) % len(ENDS))
    for number in order:
        ENDS[number](world)
        assert world.is_left_alone(), ENDS[number].__name__
    world.graph.spin(12.0)
    succeeds(world)
    assert len(world.client.states[-1].status_list) <= 2, 'old paths are kept'


def test_a_goal_pose_that_comes_meanwhile_is_ignored_and_one_that_comes_later_is_not(world):
    publisher = world.base.robot.publishers['goal_pose']
    elsewhere = PoseStamped(header=header_message(0, 'odom'))
    elsewhere.pose.position.y = 50.0
    known = world.ahead(2.0)
    world.moves()
    publisher.publish(elsewhere)
    assert world.client.outcome(known)[0] == SUCCEEDED
    assert abs(world.base.state.robot.position[0, 1]) < 10.0
    assert FAULTS['path and goal_pose'].said in world.log.read_text()
    publisher.publish(elsewhere)
    world.moves()
    start = world.base.state.robot.position[0].copy()
    assert world.client.outcome(world.client.send(line(start, start + [0, -2.0])))[0] == SUCCEEDED
    assert world.is_left_alone(), 'the goal that a path took the place of must not come back'


def test_a_limit_of_speed_counts_until_it_is_lifted(world):
    from nav2_msgs.msg import SpeedLimit

    publisher = world.graph.node.create_publisher(SpeedLimit, 'speed_limit', 10)
    world.graph.wait(publisher.get_subscription_count, 'reader of the limit')
    for percentage, limit, largest in (
        (True, 60.0, 1.2), (False, 0.8, 0.8), (False, math.nan, 0.8), (False, 0.0, 2.0),
    ):  # fmt: skip
        publisher.publish(SpeedLimit(percentage=percentage, speed_limit=limit))
        world.graph.spin(0.2)
        known = world.ahead(1.2)
        assert world.client.outcome(known)[0] == SUCCEEDED
        assert max(one.speed for one in known.feedback) == pytest.approx(largest, abs=0.05)


def test_while_the_node_is_not_active_paths_are_refused_and_its_end_ends_a_path(world):
    known = world.ahead(6.0)
    world.moves()
    assert change_state(world.graph, 'deactivate')
    world.client.ends(known, 'path deactivated')
    assert world.base.stands()
    assert not world.ahead(1.0).handle.accepted, FAULTS['path too early'].said
    assert change_state(world.graph, 'cleanup') and change_state(world.graph, 'configure')
    assert change_state(world.graph, 'activate')
    world.client.wait()
    succeeds(world)
