"""Laws of the quick reading of requests: it says what rclpy's own says, and takes no time."""

import time

from helpers.nav2_interfaces import nav2_interfaces
from helpers.path_client import line, path_of
import numpy as np
import pytest
import rclpy
from rclpy.action import ActionClient, ActionServer, GoalResponse

from socialnav.messages.follow_requests import readable
from socialnav.messages.paths import MIXED
from socialnav.nav2.light_action import follow_path_type

LONGEST_READING = 0.005
"""Time to read a path of 2,000 poses, s: rclpy takes some ten times as long."""


@pytest.fixture(scope='module', autouse=True)
def interfaces():
    """Have nav2's interfaces."""
    with nav2_interfaces():
        yield


@pytest.fixture
def arrivals(graph):
    """Return a function that sends a goal and returns what a server is asked then."""
    requests = []

    def refuse(request):
        requests.append(request)
        return GoalResponse.REJECT

    server_node = rclpy.create_node('server')
    server = ActionServer(
        server_node, follow_path_type(), 'follow_path', lambda handle: None, goal_callback=refuse
    )
    graph.executor.add_node(server_node)
    from nav2_msgs.action import FollowPath

    client = ActionClient(graph.node, FollowPath, 'follow_path')
    graph.wait(client.server_is_ready, 'server')

    def sent(goal):
        future = client.send_goal_async(goal)
        graph.wait(future.done, 'answer')
        assert not future.result().accepted
        return requests.pop()

    yield sent
    server.destroy()
    server_node.destroy_node()


@pytest.mark.parametrize('frame', ['', 'odom', 'a_frame_that_is_longer_than_usual'])
@pytest.mark.parametrize('poses', [0, 1, 2, 300])
def test_what_is_read_is_what_was_sent(arrivals, poses, frame):
    from nav2_msgs.action import FollowPath

    goal = FollowPath.Goal(
        path=path_of(line((1.5, -2.0), (7.0, 3.25), poses), yaw=0.7, frame=frame),
        controller_id='one', goal_checker_id='', progress_checker_id='three',
    )  # fmt: skip
    goal.path.header.stamp.sec, goal.path.header.stamp.nanosec = 17, 19
    request = arrivals(goal)
    assert (request.controller_id, request.goal_checker_id, request.progress_checker_id) == (
        'one', '', 'three',
    )  # fmt: skip
    np.testing.assert_array_equal(request.path.points, line((1.5, -2.0), (7.0, 3.25), poses))
    assert request.path.header == request.end.header == goal.path.header
    assert request.path.frame == (frame if poses else '')
    if poses:
        assert request.end.pose == goal.path.poses[-1].pose


def test_frames_that_differ_are_noticed(arrivals):
    from nav2_msgs.action import FollowPath

    path = path_of(line((0, 0), (1, 1), 50))
    path.poses[33].header.frame_id = 'map'
    assert arrivals(FollowPath.Goal(path=path)).path.frame == MIXED


def test_a_long_path_does_not_keep_the_node_from_deciding(arrivals):
    from nav2_msgs.action import FollowPath

    goal = FollowPath.Goal(path=path_of(line((0, 0), (100, 0), 2000)))
    from socialnav.messages import follow_requests

    original, times = follow_requests.request_of, []

    def timed(message):
        began = time.perf_counter()
        request = original(message)
        times.append(time.perf_counter() - began)
        return request

    follow_requests.request_of = timed
    try:
        for _ in range(5):
            assert len(arrivals(goal).path.points) == 2000
    finally:
        follow_requests.request_of = original
    assert min(times) < LONGEST_READING


def test_an_action_that_is_laid_out_otherwise_is_not_read():
    known = {
        'path': 'nav_msgs/Path', 'controller_id': 'string', 'goal_checker_id': 'string',
        'progress_checker_id': 'string',
    }  # fmt: skip
    assert readable(known) and readable(known | {'path_handler_id': 'string'})
    assert not readable({'tracking_id': 'string'} | known)
    assert not readable({'path': 'nav_msgs/Path'})
