"""The demo, as a user runs it; the last file, since it takes longest."""

import json
import os
from pathlib import Path
import re
import signal
import subprocess
import time

from ament_index_python.packages import get_package_prefix
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from PIL import Image
import pytest

from socialnav_core.simulation import make_scenario, Simulator

DEMO = Path(get_package_prefix('socialnav')) / 'lib' / 'socialnav' / 'demo'
FIELDS = {
    'scenario', 'seed', 'case_index', 'outcome', 'time', 'path_length', 'minimum_clearance',
    'steps',
}  # fmt: skip


ISOLATION = ('ROS_DOMAIN_ID', 'ROS_AUTOMATIC_DISCOVERY_RANGE')


def demo(*arguments):
    """Return a running demo that has to keep to itself, in a domain of its own choice."""
    environment = {name: os.environ[name] for name in os.environ if name not in ISOLATION}
    return subprocess.Popen(
        ['timeout', '-k', '5', '150', str(DEMO), *map(str, arguments)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment,
    )  # fmt: skip


def processes_of(process):
    """Return the process ids of a demo and of the nodes that it has started."""
    columns = ['-o', 'pid=', '-o', 'ppid=', '-o', 'args=']
    found = subprocess.run(
        ['ps', '-e', '-ww', *columns], capture_output=True, text=True, check=True
    )
    rows = [line.split(None, 2) for line in found.stdout.splitlines()]
    demos = [row[0] for row in rows if row[1] == str(process.pid)]
    return demos, [row[0] for row in rows if row[1] in demos and '_node' in row[2]]


def wait_for_nodes(process):
    """
    Return the process ids of the nodes of a demo as soon as there are both.

    For a moment after exec the kernel shows the arguments of a process, and no variables yet.
    """
    deadline = time.monotonic() + 40
    while len(nodes := processes_of(process)[1]) < 2 or not all(map(environment_of, nodes)):
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.05)
    return nodes


def environment_of(number):
    """Return the environment of a process as the kernel shows it, '' when it shows none."""
    return Path(f'/proc/{number}/environ').read_text()


def variables_of(number):
    """Return the environment of a process, as NAME=value."""
    return environment_of(number).split('\0')


def alive(number):
    """Return whether a process runs."""
    return (
        Path(f'/proc/{number}/cmdline').exists() and Path(f'/proc/{number}/cmdline').read_bytes()
    )


@pytest.fixture(scope='module')
def result(tmp_path_factory):
    """Return what five episodes printed, and the folder that they filled."""
    folder = tmp_path_factory.mktemp('demo')
    began = time.monotonic()
    process = demo('--episodes', 5, '--scenario', 'hard', '--out', folder)
    heading, first = process.stdout.readline(), process.stdout.readline()
    until_first = time.monotonic() - began
    rest, errors = process.communicate()
    assert process.returncode == 0, errors
    return heading + first + rest, folder, until_first


def test_the_demo_prints_a_line_per_episode_below_a_heading_and_a_summary(result):
    text, _, _ = result
    lines = [line for line in text.splitlines() if re.match(r'\s+\d+\s+hard\s', line)]
    assert [int(line.split()[0]) for line in lines] == [1, 2, 3, 4, 5]
    assert text.index('outcome') < text.index(lines[0])
    assert re.search(r'^\d of 5 reached the goal', text, re.MULTILINE)


def test_the_demo_writes_every_episode(result):
    _, folder, _ = result
    episodes = json.loads((folder / 'episodes.json').read_text())
    assert [set(episode) for episode in episodes] == [FIELDS] * 5
    assert [episode['case_index'] for episode in episodes] == list(range(5))
    assert sum(episode['outcome'] == 'goal' for episode in episodes) >= 4


def test_the_demo_draws_a_moving_picture(result):
    _, folder, _ = result
    with Image.open(folder / 'episode.gif') as picture:
        assert picture.format == 'GIF' and picture.n_frames > 20


def test_the_demo_keeps_what_was_published_as_a_bag(result):
    _, folder, _ = result
    episodes = json.loads((folder / 'episodes.json').read_text())
    heard = {}
    with (folder / 'episodes.mcap').open('rb') as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for _, channel, record, message in reader.iter_decoded_messages():
            heard.setdefault(channel.topic, {})[record.log_time] = message
    ends = [(end.case_index, end.outcome) for end in heard['/episode_result'].values()]
    assert ends[:5] == [(one['case_index'], one['outcome']) for one in episodes]
    states = sum(one['steps'] + 1 for one in episodes)
    assert len(heard['/odom']) >= states and len(heard['/cmd_vel']) >= states - 5
    assert heard['/odom'].keys() >= heard['/cmd_vel'].keys()
    place = next(iter(heard['/odom'].values())).pose.pose.position
    start = Simulator(make_scenario('hard'), batch_size=1).reset(seed=0, cases=[0])
    assert (place.x, place.y) == tuple(start.robot.position[0])


def test_a_demo_that_cannot_write_says_so_before_it_starts(tmp_path):
    (tmp_path / 'file').write_text('')
    _, errors = (process := demo('--out', tmp_path / 'file')).communicate()
    assert process.returncode == 1 and errors.startswith('error: ') and errors.count('\n') == 1


def test_the_first_episode_is_over_soon(result):
    assert result[2] < 30.0


def test_the_demo_fails_when_a_node_dies(tmp_path):
    process = demo('--model', 'orca', '--out', tmp_path, '--real-time')
    nodes = wait_for_nodes(process)
    os.kill(int(nodes[0]), signal.SIGKILL)
    _, errors = process.communicate()
    assert process.returncode == 1 and 'ended with exit code -9' in errors
    assert not any(map(alive, nodes))


def test_the_demo_fails_with_the_reason_when_there_is_no_such_model(tmp_path):
    process = demo('--model', 'nobody', '--out', tmp_path)
    _, errors = process.communicate()
    assert process.returncode == 1 and "no model 'nobody'" in errors


def test_the_nodes_of_a_demo_are_heard_on_this_machine_only(tmp_path):
    process = demo('--model', 'orca', '--out', tmp_path, '--real-time')
    nodes = wait_for_nodes(process)
    assert all('ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST' in variables_of(one) for one in nodes)
    domains = {word for one in nodes for word in variables_of(one) if 'ROS_DOMAIN_ID=' in word}
    assert len(domains) == 1
    process.terminate()
    process.communicate()


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_demo_takes_its_nodes_with_it(tmp_path, number):
    process = demo('--model', 'orca', '--out', tmp_path, '--real-time')
    nodes = wait_for_nodes(process)
    process.send_signal(number)
    process.communicate()
    assert process.returncode != 0
    assert not any(map(alive, nodes))


def test_a_robot_that_only_measures_reaches_its_goal(tmp_path):
    options = ('--sensors', '--scenario', 'simple', '--seed', 3, '--episodes', 1)
    process = demo(*options, '--out', tmp_path)
    text, errors = process.communicate()
    assert process.returncode == 0, errors
    assert '1 of 1 reached the goal' in text and re.search(
        r'^\d+ of \d+ decisions were late', text, re.MULTILINE
    )


def test_the_nodes_of_a_demo_that_is_killed_end_by_themselves(tmp_path):
    process = demo('--model', 'orca', '--out', tmp_path, '--real-time')
    nodes = wait_for_nodes(process)
    (number,), _ = processes_of(process)
    os.kill(int(number), signal.SIGKILL)
    process.communicate()
    deadline = time.monotonic() + 10
    while any(map(alive, nodes)):
        assert time.monotonic() < deadline, 'a node outlives the demo'
        time.sleep(0.05)


def test_a_scenario_that_does_not_exist_is_a_mistake_of_usage():
    process = demo('--scenario', 'hart')
    _, errors = process.communicate()
    assert process.returncode == 2 and 'did you mean hard' in errors
