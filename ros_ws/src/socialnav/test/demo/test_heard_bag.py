"""A bag that socialnav_core writes is what the nodes would have said."""

from importlib import import_module
from pathlib import Path
import re

from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import PoseStamped, Twist
from helpers.worlds import messages_of, random_state
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
import numpy as np
import pytest
from rclpy.serialization import deserialize_message, serialize_message
from visualization_msgs.msg import MarkerArray

from socialnav.demo.bag import open_bag
from socialnav.messages.filling import filled
from socialnav_core.messages import world_markers
from socialnav_core.viewing import bag
from socialnav_core.viewing.recording import Recording
from socialnav_core.viewing.ros2msg import definitions

STAMP = bag.START + 500_000_000  # the random worlds are half a second old


def records(path):
    """Return topic, time, name of the type and bytes of each message."""
    with path.open('rb') as file:
        found = make_reader(file).iter_messages()
        return [(channel.topic, one.log_time, kind.name, one.data) for kind, channel, one in found]


def installed(kind):
    """Return the fields of an installed message as (type, name, default), without constants."""
    package, name = kind.split('/')
    path = Path(get_package_share_directory(package)) / 'msg' / f'{name}.msg'
    lines = [re.sub(r'#.*', '', line).split() for line in path.read_text().splitlines()]
    own = [line for line in lines if line and '=' not in ''.join(line)]
    return [[full(package, words[0]), *words[1:]] for words in own]


def full(package, kind):
    """Return a type with its package where it is a message."""
    local = f'{package}/{kind.split("[")[0]}' in definitions()
    return f'{package}/{kind}' if local else kind


@pytest.mark.parametrize('kind', definitions())
def test_the_definitions_of_the_core_are_those_of_the_installed_messages(kind):
    assert [line.split() for line in definitions()[kind].splitlines()] == installed(kind)


def test_an_offline_bag_has_the_messages_that_the_nodes_publish(tmp_path):
    state = random_state(0)
    recording = Recording([state], 'hard', 0, 0, 'goal', 'orca')
    bag.write_bag(recording, tmp_path / 'episode.mcap')
    written = {topic: data for topic, _, _, data in records(tmp_path / 'episode.mcap')}
    published = messages_of(state, STAMP) | {
        'markers': filled(MarkerArray, world_markers(state, 0.3, STAMP, 'odom'))
    }
    for topic, message in published.items():
        sent, kind = serialize_message(message), type(message)
        assert deserialize_message(written[f'/{topic}'], kind) == deserialize_message(sent, kind)


def test_every_message_of_an_offline_bag_can_be_read_by_ros(tmp_path):
    states = [random_state(seed) for seed in range(2)]
    commands = [np.array([0.3, 0.4])]
    recording = Recording(states, 'hard', 5, 6, 'timeout', 'orca', commands=commands)
    bag.write_bag(recording, tmp_path / 'episode.mcap')
    read = {}
    for topic, _, name, data in records(tmp_path / 'episode.mcap'):
        package, kind = name.split('/msg/')
        read[topic] = deserialize_message(data, getattr(import_module(f'{package}.msg'), kind))
    assert read.keys() == {f'/{topic}' for topic in bag.TYPES}
    linear, result = read['/cmd_vel'].twist.linear, read['/episode_result']
    assert np.hypot(linear.x, linear.y) == pytest.approx(0.5)
    assert (result.seed, result.case_index, result.outcome) == (5, 6, 'timeout')


def test_what_is_heard_is_kept_at_its_time_and_can_be_read_without_ros(tmp_path):
    path, moment = tmp_path / 'heard.mcap', messages_of(random_state(0), STAMP)
    with open_bag(path) as heard:
        heard.write('/goal_pose', moment['goal_pose'])
        heard.write('/cmd_vel', Twist())
        assert not path.exists()
    assert [record[:3] for record in records(path)] == [
        ('/goal_pose', STAMP, 'geometry_msgs/msg/PoseStamped'),
        ('/cmd_vel', STAMP, 'geometry_msgs/msg/Twist'),
    ]
    with path.open('rb') as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        assert reader.get_header().profile == 'ros2'
        _, _, _, goal = next(reader.iter_decoded_messages())
    assert goal.pose.position.x == moment['goal_pose'].pose.position.x


def test_nothing_is_left_of_a_bag_that_was_not_finished(tmp_path):
    with pytest.raises(KeyError), open_bag(tmp_path / 'broken.mcap') as broken:
        broken.write('/goal_pose', PoseStamped())
        raise KeyError
    assert not list(tmp_path.iterdir())
