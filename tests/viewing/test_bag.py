"""A bag holds the episode that was recorded, and everything that is needed to read it."""

from collections import Counter
import dataclasses

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
import numpy as np
import pytest

from socialnav_core.policies import OrcaPolicy, StraightLinePolicy
from socialnav_core.simulation import make_scenario
from socialnav_core.viewing import bag, record


@pytest.fixture(scope='module')
def recording():
    return record(OrcaPolicy(), make_scenario('hard'), seed=7, case_index=2, name='orca')


@pytest.fixture(scope='module')
def path(recording, tmp_path_factory):
    path = tmp_path_factory.mktemp('bag') / 'episode.mcap'
    bag.write_bag(recording, path)
    return path


def decoded(path, *topics):
    """Return topic, time in ns and content of each message."""
    with path.open('rb') as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        found = reader.iter_decoded_messages(topics or None)
        return [(channel.topic, record.log_time, message) for _, channel, record, message in found]


def messages(path, topic):
    """Return time, s since the first state, and content of each message of a topic."""
    return [((time - bag.START) * 1e-9, message) for _, time, message in decoded(path, topic)]


def test_a_bag_has_the_profile_and_the_types_of_ros_2(path):
    with path.open('rb') as file:
        reader = make_reader(file)
        assert reader.get_header().profile == 'ros2'
        summary = reader.get_summary()
    assert {schema.encoding for schema in summary.schemas.values()} == {'ros2msg'}
    types = {
        channel.topic: summary.schemas[channel.schema_id].name
        for channel in summary.channels.values()
    }
    assert types == {f'/{topic}': bag.full_name(kind) for topic, kind in bag.TYPES.items()}


def test_every_state_is_there_once_with_a_command_for_all_but_the_last(path, recording):
    counts = Counter(topic for topic, *_ in decoded(path))
    states = len(recording.states)
    assert counts == {
        **dict.fromkeys(('/pedestrians', '/obstacles', '/odom', '/goal_pose', '/markers'), states),
        '/cmd_vel': states - 1,
        '/episode_result': 1,
    }


def test_everybody_is_where_they_were_when_they_were_there(path, recording):
    times, odometry = zip(*messages(path, '/odom'), strict=True)
    np.testing.assert_allclose(times, recording.times)
    seen = [(one.pose.pose.position.x, one.pose.pose.position.y) for one in odometry]
    np.testing.assert_array_equal(seen, recording.robot_path)
    for (_, crowd), state in zip(messages(path, '/pedestrians'), recording.states, strict=True):
        seen = [(agent.position.x, agent.position.y) for agent in crowd.agents]
        np.testing.assert_array_equal(
            seen, state.agents.position[0, [agent.id for agent in crowd.agents]]
        )


def test_stamps_are_the_times_at_which_messages_are_kept(path):
    for _, time, message in decoded(path, '/odom', '/cmd_vel', '/episode_result'):
        stamp = message.header.stamp
        assert stamp.sec * 10**9 + stamp.nanosec == time


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
def test_the_commands_lead_from_each_state_to_the_next(kinematics, tmp_path):
    scenario = dataclasses.replace(make_scenario('circle'), kinematics=kinematics)
    policy = StraightLinePolicy()
    policy.kinematics = kinematics
    if kinematics == 'differential':
        policy.act = lambda state, limits: np.array([[0.5, 0.2]])
    recording = record(policy, scenario, seed=1)
    bag.write_bag(recording, tmp_path / 'episode.mcap')
    twists = [one.twist for _, one in messages(tmp_path / 'episode.mcap', '/cmd_vel')]
    steps = zip(recording.states[:-1], recording.states[1:], twists, strict=True)
    for before, after, twist in steps:
        way = np.linalg.norm(after.robot.position - before.robot.position)
        elapsed = float(after.time[0] - before.time[0])
        speed = np.hypot(twist.linear.x, twist.linear.y)
        assert way == pytest.approx(speed * elapsed, abs=2e-4)
        turned = float(after.robot.heading[0] - before.robot.heading[0])
        if kinematics == 'differential':
            assert np.sin(turned) == pytest.approx(np.sin(twist.angular.z * elapsed))


def test_the_result_is_that_of_the_recording(path, recording):
    [(time, result)] = messages(path, '/episode_result')
    assert (result.scenario, result.seed, result.case_index) == ('hard', 7, 2)
    assert result.time == recording.times[-1] == pytest.approx(time)
    assert result.outcome == recording.outcome.split('_')[0]
    assert result.steps == len(recording.states) - 1
