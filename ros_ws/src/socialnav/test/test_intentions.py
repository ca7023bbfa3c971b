"""Laws of what is shown of a decision."""

import math

from geometry_msgs.msg import Twist
from nav_msgs.msg import Path
import numpy as np
import pytest
from robot import drives
import torch
from visualization_msgs.msg import Marker, MarkerArray
from worlds import random_state

from socialnav import qos
from socialnav.messages.intentions import attention_markers, planned_path, predicted_path
from socialnav_core.config import Config, PolicyConfig
from socialnav_core.policies import build_network
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.simulation import make_scenario


def places(path):
    """Return the positions of a path, (poses, 2)."""
    return np.array([(one.pose.position.x, one.pose.position.y) for one in path.poses])


def test_a_path_begins_at_the_robot_and_is_as_long_as_the_way_of_a_second():
    state = random_state(0)
    found = places(predicted_path(state, np.array([0.3, -0.4]), 'holonomic', 7, 'odom'))
    np.testing.assert_allclose(found[0], state.robot.position[0])
    np.testing.assert_allclose(found[-1] - found[0], [0.3, -0.4])


def test_the_path_of_a_differential_drive_is_an_arc():
    state = random_state(0)
    state.robot.heading[:] = 0.0
    found = places(predicted_path(state, np.array([0.5, math.pi]), 'differential', 7, 'odom'))
    np.testing.assert_allclose(found[-1] - found[0], [0.0, 1.0 / math.pi], atol=1e-9)


def test_the_path_of_a_plan_leads_from_the_robot_through_all_of_it():
    state = random_state(0)
    plan = state.robot.position[0] + np.array([[0.0, 1.0], [-1.0, 1.0]])
    path = planned_path(state, plan, 7, 'odom')
    np.testing.assert_allclose(places(path), [state.robot.position[0], *plan])
    turns = [2 * math.atan2(one.pose.orientation.z, one.pose.orientation.w) for one in path.poses]
    np.testing.assert_allclose(turns[1:], [math.pi / 2, math.pi], atol=1e-9)


def test_an_agent_is_the_denser_the_more_it_is_looked_at():
    weights = np.array([0.5, 0.1, 0.2, 0.15, 0.05])
    markers = attention_markers(random_state(0), weights, 7, 'odom').markers
    assert markers[0].action == Marker.DELETEALL and len(markers) == 6
    np.testing.assert_allclose([one.color.a for one in markers[1:]], weights, rtol=1e-6)


@pytest.fixture
def untrained(tmp_path):
    """Return a checkpoint with random weights."""
    torch.manual_seed(0)
    policy = PolicyConfig()
    save_weights(
        tmp_path, build_network(policy), Config('u', make_scenario('hard'), policy=policy)
    )
    return tmp_path


def test_who_listens_sees_path_and_attention_of_a_robot_that_drives(graph, untrained):
    commands = graph.listen(Twist, 'cmd_vel', qos.COMMAND)
    paths = graph.listen(Path, 'policy_node/predicted_path', qos.PREDICTED_PATH)
    attention = graph.listen(MarkerArray, 'policy_node/attention', qos.ATTENTION)
    graph.start('simulator_node')
    graph.start('policy_node', model=untrained, bounds=7.5)
    drives(graph, commands)
    graph.wait(lambda: paths and attention, 'path and attention')
    assert paths[-1].header.frame_id == 'odom' and len(places(paths[-1])) > 2
    densities = [one.color.a for one in attention[-1].markers[1:]]
    assert sum(densities) == pytest.approx(1.0, abs=1e-4)
