"""Laws of `ros2 topic`."""

import signal
import time

from command_line import DEADLINE, output, refusal, start, wait_for_line
from graph_under_test import RATE, Talker
import pytest
import yaml

pytestmark = pytest.mark.usefixtures('talker')


def test_the_list_shows_types_and_leaves_hidden_topics_out() -> None:
    lines = output('topic', 'list', '-t').splitlines()
    assert lines == sorted(lines)
    assert '/crowd/pose [geometry_msgs/msg/PoseStamped]' in lines
    assert '/heard [std_msgs/msg/String]' in lines
    assert not any('_secret' in line for line in lines)


def test_the_list_without_types_holds_names_only() -> None:
    assert {'/crowd/pose', '/once', '/mixed'} <= set(output('topic', 'list').splitlines())


def test_info_counts_publishers_and_subscriptions() -> None:
    expected = 'Type: std_msgs/msg/String\nPublisher count: 2\nSubscription count: 0\n'
    assert output('topic', 'info', '/mixed') == expected


def test_verbose_info_tells_the_node_and_the_qos_of_each_endpoint() -> None:
    text = output('topic', 'info', '-v', '/once')
    assert 'Node name: talker\nNode namespace: /crowd\n' in text
    assert 'Reliability: RELIABLE' in text
    assert 'Durability: TRANSIENT_LOCAL' in text


def test_info_of_a_topic_that_nobody_uses_is_refused() -> None:
    assert refusal('topic', 'info', '/nowhere') == "Unknown topic '/nowhere'"


def test_echo_hears_what_was_published_before_on_a_latched_topic() -> None:
    assert output('topic', 'echo', '--once', '/once') == 'data: said before\n---\n'


def test_echo_hears_publishers_of_different_reliability() -> None:
    process = start('topic', 'echo', '/mixed')
    wait_for_line(process, 'data: reliable')
    wait_for_line(process, 'data: unreliable')
    process.kill()
    process.communicate()


def test_echo_of_a_best_effort_topic_is_the_message_as_yaml() -> None:
    document = output('topic', 'echo', '--once', 'crowd/pose').removesuffix('---\n')
    assert yaml.safe_load(document) == {
        'header': {'stamp': {'sec': 0, 'nanosec': 0}, 'frame_id': 'map'},
        'pose': {
            'position': {'x': 1.5, 'y': 0.0, 'z': 0.0},
            'orientation': {'x': 0.0, 'y': 0.0, 'z': 0.0, 'w': 1.0},
        },
    }


def test_a_field_is_printed_alone() -> None:
    text = output('topic', 'echo', '--once', '/crowd/pose', '--field', 'pose.position')
    assert text == 'x: 1.5\ny: 0.0\nz: 0.0\n---\n'


def test_a_field_that_does_not_exist_is_refused() -> None:
    error = refusal('topic', 'echo', '--once', '/crowd/pose', '--field', 'pose.size')
    assert error.startswith("Invalid field 'pose.size'")


def test_echo_of_an_unknown_type_is_refused() -> None:
    error = refusal('topic', 'echo', '/once', 'std_msgs/msg/Nothing')
    assert error == "The message type 'std_msgs/msg/Nothing' is invalid"


def test_hz_measures_the_rate() -> None:
    process = start('topic', 'hz', '/crowd/pose')
    rate = float(wait_for_line(process, 'average rate').split(':')[1])
    process.kill()
    process.communicate()
    assert rate == pytest.approx(RATE, rel=0.2)


def test_one_message_is_published_to_whoever_listens(talker: Talker) -> None:
    text = output('topic', 'pub', '--once', '/heard', 'std_msgs/msg/String', '{data: hello}')
    lines = text.removeprefix('Waiting for at least 1 matching subscription(s)...\n')
    assert lines == (
        "publisher: beginning loop\npublishing #1: std_msgs.msg.String(data='hello')\n\n"
    )
    deadline = time.monotonic() + DEADLINE
    while 'hello' not in talker.heard:
        assert time.monotonic() < deadline


def test_a_message_is_published_at_a_rate_until_it_is_interrupted() -> None:
    process = start('topic', 'pub', '-r', '50', '/heard', 'std_msgs/msg/String', '{data: again}')
    wait_for_line(process, 'publishing #3')
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=DEADLINE)
    assert (process.returncode, errors) == (2, '')


def test_a_message_that_does_not_fit_is_refused_before_anything_is_published() -> None:
    error = refusal('topic', 'pub', '/heard', 'std_msgs/msg/String', '{text: hello}')
    assert error.startswith('Failed to populate field: ')


@pytest.mark.parametrize(('number', 'status'), [(signal.SIGINT, 2), (signal.SIGTERM, 143)])
def test_a_signal_ends_echo_without_a_traceback(number: signal.Signals, status: int) -> None:
    process = start('topic', 'echo', '/once')
    wait_for_line(process, 'data')
    process.send_signal(number)
    _, errors = process.communicate(timeout=DEADLINE)
    assert (process.returncode, errors) == (status, '')


def test_echo_ends_quietly_when_its_reader_goes() -> None:
    process = start('topic', 'echo', '/mixed')
    wait_for_line(process, 'data')
    process.stdout.close()
    assert process.wait(timeout=DEADLINE) == 0
    assert process.stderr.read() == ''
