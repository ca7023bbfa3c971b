"""Laws of what is shown of a decision."""

from geometry_msgs.msg import Twist
from helpers.robot import drives
from nav_msgs.msg import Path
import pytest
import torch
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav_core.config import Config, PolicyConfig
from socialnav_core.policies import build_network
from socialnav_core.policies.value.checkpoint import save_weights
from socialnav_core.simulation import make_scenario


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
    assert paths[-1].header.frame_id == 'odom' and len(paths[-1].poses) > 2
    densities = [one.color.a for one in attention[-1].markers[1:]]
    assert sum(densities) == pytest.approx(1.0, abs=1e-4)
