"""Laws of `ros2 param`."""

from pathlib import Path

from command_line import output, refusal, ros2
from graph_under_test import Talker
import pytest
from rclpy.parameter import get_parameter_value
from small_ros2 import clients
from small_ros2.command import CommandError
from small_ros2.param import value_text
from small_ros2.param_describe import descriptors
import yaml

pytestmark = pytest.mark.usefixtures('talker')


def test_the_list_of_a_node_holds_its_parameters_with_their_types() -> None:
    lines = output('param', 'list', '/crowd/talker', '--param-type').splitlines()
    assert lines == sorted(lines)
    assert {'  speed (type: double)', '  waypoints (type: integer array)'} <= set(lines)


def test_the_list_without_a_node_tells_each_parameters_node() -> None:
    lines = output('param', 'list').splitlines()
    assert lines[0] == '/crowd/talker:'
    assert '  speed' in lines


def test_a_value_that_was_set_is_the_one_that_is_read() -> None:
    assert output('param', 'set', '/crowd/talker', 'speed', '1.25') == 'Set parameter successful\n'
    assert output('param', 'get', 'crowd/talker', 'speed') == 'Double value is: 1.25\n'


def test_a_value_that_the_node_refuses_is_an_error() -> None:
    error = refusal('param', 'set', '/crowd/talker', 'speed', '9.0')
    assert error.startswith('Setting parameter failed: ')


def test_the_description_tells_type_meaning_and_range() -> None:
    assert output('param', 'describe', '/crowd/talker', 'speed') == (
        'Parameter name: speed\n'
        '  Type: double\n'
        '  Description: speed to walk at [m/s]\n'
        '  Constraints:\n'
        '    Min value: 0.0\n'
        '    Max value: 2.0\n'
    )


def test_a_dump_is_a_file_of_parameters() -> None:
    values = yaml.safe_load(output('param', 'dump', 'crowd/talker'))['/crowd/talker']
    assert (
        values['ros__parameters'].items() >= {'waypoints': [1, 2], 'use_sim_time': False}.items()
    )
    assert 'speed' in values['ros__parameters']


def test_what_was_loaded_is_the_value_that_is_read_and_a_refusal_is_told(tmp_path: Path) -> None:
    file = tmp_path / 'parameters.yaml'
    file.write_text(
        '/**: {ros__parameters: {speed: 0.1, waypoints: [9.0]}}\n'
        '/crowd/talker: {ros__parameters: {speed: 1.75}}\n'
    )
    result = ros2('param', 'load', '/crowd/talker', str(file))
    assert (result.returncode, result.stdout) == (0, 'Set parameter speed successful\n')
    assert result.stderr.startswith('Set parameter waypoints failed: Wrong parameter type')
    assert output('param', 'get', '/crowd/talker', 'speed') == 'Double value is: 1.75\n'
    assert 'waypoints' not in output(
        'param', 'load', '/crowd/talker', str(file), '--no-use-wildcard'
    )


@pytest.mark.parametrize(
    'text', ['/other: {ros__parameters: {}}', '/crowd/talker: 3', '3', '{', '']
)
def test_a_file_without_parameters_of_the_node_is_refused(text: str, tmp_path: Path) -> None:
    file = tmp_path / 'parameters.yaml'
    file.write_text(text)
    error = refusal('param', 'load', '/crowd/talker', str(file))
    assert 'cannot be loaded' in error and '\n' not in error


def test_a_file_that_is_not_there_is_refused() -> None:
    assert 'No such file' in refusal('param', 'load', '/crowd/talker', 'nowhere.yaml')


def test_a_node_that_is_not_there_is_refused(
    talker: Talker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(clients, 'PATIENCE', 0.1)
    with pytest.raises(CommandError, match='Node not found'):
        descriptors(talker.node, '/talker', ['speed'])


@pytest.mark.parametrize(
    ('value', 'text'),
    [
        ('true', 'Boolean value is: True'),
        ('3', 'Integer value is: 3'),
        ('hard', 'String value is: hard'),
        ('[0.5]', "Double values are: array('d', [0.5])"),
        ('[a, b]', "String values are: ['a', 'b']"),
    ],
)
def test_a_value_is_shown_with_its_type_unless_that_is_hidden(value: str, text: str) -> None:
    message = get_parameter_value(value)
    assert value_text(message, hide_type=False) == text
    assert value_text(message, hide_type=True) == text.split(': ', 1)[1]
